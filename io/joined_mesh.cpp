// SPDX-License-Identifier: Apache-2.0
#include "io/joined_mesh.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace twinray {
namespace {

/// Indices of a corner's position, normal and texture coordinates; 0 for what the mesh has not.
using Corner = std::array<std::uint32_t, 4>;

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t index : corner) hash = (hash ^ index) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
  }
};

}  // namespace

JoinedMesh join_corners(const Mesh& mesh) {
  JoinedMesh joined;
  std::unordered_map<Corner, std::uint32_t, CornerHash> numbers;
  joined.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triangle& triangle = joined.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner corner{mesh.triangles[i][k], mesh.normals.empty() ? 0 : mesh.normal_indices[i][k],
                          mesh.uvs.empty() ? 0 : mesh.uv_indices[i][k],
                          mesh.second_uvs.empty() ? 0 : mesh.second_uv_indices[i][k]};
      const auto [place, is_new] = numbers.try_emplace(corner, std::uint32_t(joined.positions.size()));
      triangle[k] = place->second;
      if (!is_new) continue;
      joined.positions.push_back(mesh.positions[corner[0]]);
      if (!mesh.normals.empty()) joined.normals.push_back(mesh.normals[corner[1]]);
      if (!mesh.uvs.empty()) joined.uvs.push_back(mesh.uvs[corner[2]]);
      if (!mesh.second_uvs.empty()) joined.second_uvs.push_back(mesh.second_uvs[corner[3]]);
    }
  }
  return joined;
}

}  // namespace twinray
