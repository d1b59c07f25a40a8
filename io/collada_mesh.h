// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "io/collada_document.h"

namespace twinray {

/// A polygon of more than three corners of which CS184's rules keep one triangle.
struct ReducedPolygon {
  std::size_t triangle = 0;            ///< Of its part's mesh.
  std::vector<std::uint32_t> corners;  ///< All of them, as indices of positions.
};

/// One primitive element (<triangles>, <polylist>, ...) in the coordinates of its geometry.
struct ColladaPart {
  XmlElement element;
  std::string symbol;  ///< Of its material, or "".
  Mesh mesh;           ///< Triangulated; normals as the file has them, not yet of unit length.
  std::vector<std::uint32_t>
      vertices;  ///< What the file numbers the positions; nothing where it is the same.
  std::vector<ReducedPolygon> reduced;  ///< In the order of their triangles; by the standard rules none.
};

/// What a <geometry> holds: the parts of a mesh, or a sphere (CGL extension) around its origin.
struct ColladaGeometry {
  std::vector<ColladaPart> parts;
  std::optional<float> sphere_radius;
};

/// Reads a <geometry>. By CS184's rules it has one part, its first <polylist>, else its first <triangles>,
/// else all parts; and of a polygon the triangle of its last, first and second corner is kept. Throws Error
/// for indices out of range, wrong counts, a negative radius, missing inputs.
ColladaGeometry read_geometry(const XmlElement& geometry, ColladaDocument& document);

/// Warns of a mesh that is to be seen and has no parts.
void warn_where_empty(const XmlElement& geometry, const ColladaGeometry& read, ColladaDocument& document);

/// The positions of a <geometry>'s <vertices>, used or not. Throws Error where it has none.
std::vector<Vec3> read_vertices(const XmlElement& geometry, ColladaDocument& document);

}  // namespace twinray
