// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "io/collada_document.h"

namespace twinray {

/// One primitive element (<triangles>, <polylist>, ...) in the coordinates of its geometry.
struct ColladaPart {
  XmlElement element;
  std::string symbol;  ///< Of its material, or "".
  Mesh mesh;           ///< Triangulated; normals as the file has them, not yet of unit length.
};

/// What a <geometry> holds: the parts of a mesh, or a sphere (CGL extension) around its origin.
struct ColladaGeometry {
  std::vector<ColladaPart> parts;
  std::optional<float> sphere_radius;
};

/// Reads a <geometry>. Throws Error for indices out of range, wrong counts, a negative radius, missing
/// inputs.
ColladaGeometry read_geometry(const XmlElement& geometry, ColladaDocument& document);

}  // namespace twinray
