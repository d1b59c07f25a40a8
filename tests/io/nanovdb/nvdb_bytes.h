// SPDX-License-Identifier: Apache-2.0
// NanoVDB files as NanoVDB's own library writes them.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace twinray::test {

struct NvdbVoxel {
  std::array<int, 3> at;
  float value;
};

/// A grid of fog. Values of other types and kinds are for tests of what is not read.
struct NvdbContent {
  std::string name = "density";
  std::vector<NvdbVoxel> voxels;
  double voxel_size = 1;
  std::array<double, 3> origin{};  ///< Of the voxel 0 0 0.
  enum class Type { real, fp4, fp8, fp16, fpn, whole } type = Type::real;
  bool is_level_set = false;
  float background = 0;
};

enum class NvdbPacking { none, zip, blosc };

/// All in one segment.
std::string nvdb_bytes(const std::vector<NvdbContent>& grids, NvdbPacking packing = NvdbPacking::none);

}  // namespace twinray::test
