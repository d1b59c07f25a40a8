// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/geometry.h"
#include "core/transform.h"
#include "io/collada/document.h"
#include "io/collada/mesh.h"
#include "io/placed_mesh.h"

namespace twinray {

/// A mesh of an instance in world space (io/placed_mesh.h). Throws Error at the place of `instance`.
PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const XmlElement& instance);

/// The same by CS184's rules: the mesh has the normals of io/cs184/normals.h, and where the transform
/// mirrors, its triangles' fronts become their backs. Warns where the mesh is no oriented manifold. Extends
/// `bounds` by all of its positions.
PlacedMesh place_cs184_mesh(const ColladaPart& part, const Transform& to_world, const XmlElement& instance,
                            ColladaDocument& document, Aabb& bounds);

/// A sphere around its node's origin, brought to world space. Where the transform does not scale evenly (up
/// to 10^-4) its mean scale is used, with a warning; by CS184's rules that of its x axis.
Sphere place_sphere(float radius, const Transform& to_world, const XmlElement& instance,
                    ColladaDocument& document);

}  // namespace twinray
