// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/geometry.h"

namespace twinray {

/// A mesh as most formats have one: a vertex has one position, one normal and one place in each set of
/// texture coordinates. A position that triangles use with several normals or coordinates becomes several
/// vertices, in the order of their first use; one that no triangle uses is left out. The triangles keep their
/// order.
struct JoinedMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;     ///< As many, or empty.
  std::vector<Vec2> uvs;         ///< As many, or empty.
  std::vector<Vec2> second_uvs;  ///< As many, or empty.
  std::vector<Triangle> triangles;
};
JoinedMesh join_corners(const Mesh& mesh);

}  // namespace twinray
