// SPDX-License-Identifier: Apache-2.0
// Private: the points of many directions at a time.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/direction_map.h"

namespace twinray {

/// points[i] = map_point(layout, directions[i]), with the same bits, in lanes where the machine has any.
void map_points(MapLayout layout, std::span<const Vec3> directions, std::span<MapPoint> points);

/// The same by one instruction set.
struct MapPointsKernel {
  std::string name;  ///< As available_instruction_sets() has it.
  void (*map_points)(MapLayout layout, std::span<const Vec3> directions, std::span<MapPoint> points);
};
/// For those of this machine, the fastest first; none for scalar code.
std::vector<MapPointsKernel> map_points_kernels();

}  // namespace twinray
