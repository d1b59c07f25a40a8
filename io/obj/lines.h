// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"

namespace twinray {

/// Lines in space that belong together, each through two points or more.
struct LineObject {
  std::string name;  ///< Of letters, digits and underscores.
  std::vector<std::vector<Vec3>> lines;
};

/// The objects as a Wavefront OBJ file, which has no surfaces but lines ("l"): Blender and MeshLab show them.
/// Coordinates keep all their bits.
std::string obj_text(std::span<const LineObject> objects);

}  // namespace twinray
