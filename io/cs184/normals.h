// SPDX-License-Identifier: Apache-2.0
// The normals that CS184's program gives a mesh, whatever its file says: smooth ones at all vertices.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"

namespace twinray {

using DoublePoint = std::array<double, 3>;

/// Faces of three or more corners each, which are indices of vertices in winding order.
struct FaceList {
  std::vector<std::uint32_t> corners;  ///< Face after face.
  std::vector<std::size_t> ends;       ///< Where the corners of each face end.

  void add(std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    ends.push_back(corners.size());
  }
};

/// One normal for each vertex.
struct VertexNormals {
  std::vector<Vec3> normals;  ///< Unit; 0 0 0 where the rule gives none, and for vertices of no face.
  std::string fault;          ///< Why the faces are no oriented manifold; "" where they are one.
};

/// At a vertex v that faces surround the normal is that of the sum of (b - v) x (c - v) over them, where b
/// and c follow v in the face. At a vertex on a border, with w the vertex before it on that border (a face
/// has the edge from w to v, and none the one from v to w), it is that of (w - v) x (the sum of k - v over
/// all neighbours k of w): for a flat patch the opposite. The walls of CS184's boxes are wound outward, and
/// face inward by that.
///
/// That takes faces that form an oriented manifold: no edge is used twice in one direction, the faces around
/// a vertex are one fan, and no face has a vertex twice. Where they do not, all normals are those of the
/// first sum.
VertexNormals cs184_normals(const FaceList& faces, std::span<const DoublePoint> positions);

}  // namespace twinray
