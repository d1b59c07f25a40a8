// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "io/collada/mesh.h"

namespace twinray {

/// What a <geometry> holds: the parts of a mesh, or a sphere (CGL extension) around its origin.
struct ColladaGeometry {
  std::vector<ColladaPart> parts;
  std::optional<float> sphere_radius;
};

/// Reads a <geometry>. By CS184's rules it has one part, its first <polylist>, else its first <triangles>,
/// else all parts. Throws Error for a negative radius, and as read_part() does.
ColladaGeometry read_geometry(const XmlElement& geometry, ColladaDocument& document);

/// Warns of a mesh that is to be seen and has no parts.
void warn_where_empty(const XmlElement& geometry, const ColladaGeometry& read, ColladaDocument& document);

/// The positions of a <geometry>'s <vertices>, used or not. Throws Error where it has none.
std::vector<Vec3> read_vertices(const XmlElement& geometry, ColladaDocument& document);

}  // namespace twinray
