// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "io/collada/document.h"
#include "io/collada/source.h"

namespace twinray {

/// A polygon of more than three corners of which CS184's rules keep one triangle.
struct ReducedPolygon {
  std::size_t triangle = 0;            ///< Of its part's mesh.
  std::vector<std::uint32_t> corners;  ///< All of them, as indices of positions.
};

/// A further set of texture coordinates, with the indices of each triangle's corners.
struct ColladaUvs {
  std::uint32_t set = 0;  ///< As the <input> has it.
  std::vector<Vec2> uvs;
  std::vector<Triangle> indices;
};

/// One primitive element (<triangles>, <polylist>, ...) in the coordinates of its geometry.
struct ColladaPart {
  XmlElement element;
  std::string symbol;                ///< Of its material, or "".
  Mesh mesh;                         ///< Triangulated; normals as the file has them, not yet of unit length.
  std::uint32_t uv_set = 0;          ///< That of the mesh's own texture coordinates: the first one.
  std::vector<ColladaUvs> more_uvs;  ///< Those of the further <input>s.
  std::vector<std::uint32_t>
      vertices;  ///< What the file numbers the positions; nothing where it is the same.
  std::vector<ReducedPolygon> reduced;  ///< In the order of their triangles; by the standard rules none.
};

/// Reads a primitive element of a <mesh>, whose sources are shared. By CS184's rules of a polygon the
/// triangle of its last, first and second corner is kept. Throws Error for indices out of range, wrong
/// counts, missing inputs.
ColladaPart read_part(const XmlElement& element, const std::string& name, ColladaDocument& document,
                      ColladaSources& sources);

}  // namespace twinray
