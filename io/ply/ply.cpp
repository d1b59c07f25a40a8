// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "io/joined_mesh.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <typename... Numbers>
void append(std::string& bytes, const Numbers&... numbers) {
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
}

std::string header(const JoinedMesh& mesh) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n{}{}{}"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.positions.size(),
      mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n",
      mesh.uvs.empty() ? "" : "property float u\nproperty float v\n",
      mesh.second_uvs.empty() ? "" : "property float u2\nproperty float v2\n", mesh.triangles.size());
}

}  // namespace

std::string ply_bytes(const Mesh& mesh) {
  const JoinedMesh joined = join_corners(mesh);
  std::string bytes = header(joined);
  bytes.reserve(bytes.size() + joined.positions.size() * 10 * sizeof(float) + joined.triangles.size() * 13);
  for (std::size_t i = 0; i < joined.positions.size(); ++i) {
    append(bytes, joined.positions[i].x, joined.positions[i].y, joined.positions[i].z);
    if (!joined.normals.empty()) append(bytes, joined.normals[i].x, joined.normals[i].y, joined.normals[i].z);
    if (!joined.uvs.empty()) append(bytes, joined.uvs[i].x, joined.uvs[i].y);
    if (!joined.second_uvs.empty()) append(bytes, joined.second_uvs[i].x, joined.second_uvs[i].y);
  }
  for (const auto& [a, b, c] : joined.triangles) append(bytes, std::uint8_t{3}, a, b, c);
  return bytes;
}

}  // namespace twinray
