// SPDX-License-Identifier: Apache-2.0
// Shapes as the Shape statement describes them, and as the scene has them.
#pragma once
#include <optional>
#include <string>

#include "core/geometry.h"
#include "core/transform.h"
#include "io/pbrt/context.h"
#include "io/pbrt/parameters.h"

namespace twinray {

/// A shape in its own space. The front of its triangles is where pbrt's normal points while nothing turns it.
struct PbrtShape {
  Mesh mesh;
  float sphere_radius = 0;  ///< > 0: a whole sphere about the origin, and no mesh.
  /// Of how many shapes of pbrt's it consists: each triangle with an area is one, each
  /// patch of a mesh, and each face of four corners.
  std::size_t pieces = 1;
};

/// Reads a shape of this type. Nothing where it is left out, which a warning says. Throws Error where a
/// parameter is missing or wrong.
std::optional<PbrtShape> read_shape(const std::string& type, const PbrtParameters& parameters,
                                    PbrtContext& context);

/// What happened while shapes were placed.
struct PlacedShapes {
  std::size_t dropped_triangles = 0, replaced_normals = 0;
};

/// The shape in the world. The front of its triangles is pbrt's outside: where shading normals point, if it
/// has any; else the side that the transform makes of its own front; ReverseOrientation turns either. A
/// sphere stays one unless it is turned, `as_mesh` or not scaled evenly.
Shape place_shape(const PbrtShape& shape, const Transform& to_world, bool is_reversed, bool as_mesh,
                  PlacedShapes& account);

}  // namespace twinray
