// SPDX-License-Identifier: Apache-2.0
#include "io/ply.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <unordered_map>

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <typename... Numbers>
void append(std::string& bytes, const Numbers&... numbers) {
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
}

/// Indices of a corner's position, normal and texture coordinate; 0 for what the mesh has not.
using Corner = std::array<std::uint32_t, 3>;

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t index : corner) hash = (hash ^ index) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
  }
};

/// Corners as vertices of their own, numbered by their first use.
struct Vertices {
  std::vector<Corner> corners;
  std::vector<Triangle> triangles;
};

Vertices join_corners(const Mesh& mesh) {
  Vertices vertices;
  std::unordered_map<Corner, std::uint32_t, CornerHash> numbers;
  vertices.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triangle& triangle = vertices.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner corner{mesh.triangles[i][k], mesh.normals.empty() ? 0 : mesh.normal_indices[i][k],
                          mesh.uvs.empty() ? 0 : mesh.uv_indices[i][k]};
      const auto [place, is_new] = numbers.try_emplace(corner, std::uint32_t(vertices.corners.size()));
      if (is_new) vertices.corners.push_back(corner);
      triangle[k] = place->second;
    }
  }
  return vertices;
}

std::string header(const Mesh& mesh, const Vertices& vertices) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n{}{}"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      vertices.corners.size(),
      mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n",
      mesh.uvs.empty() ? "" : "property float u\nproperty float v\n", vertices.triangles.size());
}

}  // namespace

std::string ply_bytes(const Mesh& mesh) {
  const Vertices vertices = join_corners(mesh);
  std::string bytes = header(mesh, vertices);
  bytes.reserve(bytes.size() + vertices.corners.size() * 8 * sizeof(float) + vertices.triangles.size() * 13);
  for (const auto& [position, normal, uv] : vertices.corners) {
    append(bytes, mesh.positions[position].x, mesh.positions[position].y, mesh.positions[position].z);
    if (!mesh.normals.empty())
      append(bytes, mesh.normals[normal].x, mesh.normals[normal].y, mesh.normals[normal].z);
    if (!mesh.uvs.empty()) append(bytes, mesh.uvs[uv].x, mesh.uvs[uv].y);
  }
  for (const auto& [a, b, c] : vertices.triangles) append(bytes, std::uint8_t{3}, a, b, c);
  return bytes;
}

}  // namespace twinray
