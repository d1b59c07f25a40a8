// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "core/geometry.h"
#include "core/transform.h"
#include "io/collada_document.h"
#include "io/collada_mesh.h"

namespace twinray {

/// A mesh brought to world space: positions are transformed in double, normals are made unit vectors, and
/// where the transform mirrors, winding and normals are turned so that the front stays the front. Triangles
/// without area, or not finite, are dropped, and so are vertices that no triangle uses.
struct PlacedMesh {
  Mesh mesh;
  std::size_t dropped = 0;          ///< Triangles.
  std::size_t without_normals = 0;  ///< Corners whose normal was 0 0 0: they took their triangle's.
};
/// Throws Error, at the place of `instance`, where a coordinate lies beyond max_coordinate.
PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const XmlElement& instance);

/// The same by CS184's rules: the mesh has the normals of io/cs184_normals.h, and where the transform
/// mirrors, its triangles' fronts become their backs. Warns where the mesh is no oriented manifold. Extends
/// `bounds` by all of its positions.
PlacedMesh place_cs184_mesh(const ColladaPart& part, const Transform& to_world, const XmlElement& instance,
                            ColladaDocument& document, Aabb& bounds);

/// A sphere around its node's origin, brought to world space. Where the transform does not scale evenly (up
/// to 10^-4) its mean scale is used, with a warning; by CS184's rules that of its x axis.
Sphere place_sphere(float radius, const Transform& to_world, const XmlElement& instance,
                    ColladaDocument& document);

}  // namespace twinray
