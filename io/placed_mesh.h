// SPDX-License-Identifier: Apache-2.0
// Meshes of scene files as the scene has them: in world space.
#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "core/geometry.h"
#include "core/transform.h"

namespace twinray {

struct PlacedMesh {
  Mesh mesh;
  std::size_t dropped = 0;          ///< Triangles.
  std::size_t without_normals = 0;  ///< Corners whose normal was 0 0 0: they took their triangle's.
};

/// Throws Error, with the place of what is placed.
using FailPlacing = std::function<void(const std::string& message)>;

/// A mesh brought to world space: positions are transformed in double, normals are made unit vectors, and
/// where the transform mirrors, winding and normals are turned so that the front stays the front. Then it is
/// cleaned up. Fails where a coordinate lies beyond max_coordinate.
PlacedMesh place_mesh(const Mesh& local, const Transform& to_world, const FailPlacing& fail);

/// The positions alone. Those that are not finite stay; they go with their triangles.
void move_positions(Mesh& mesh, const Transform& to_world, const FailPlacing& fail);

/// The shading normals alone: as unit vectors, or 0 0 0 where they are no directions.
void turn_normals(Mesh& mesh, const Transform& to_world);

/// The box of a shape's spheres, or of all vertices of a mesh.
Aabb bounds_of(const Shape& shape);

/// Fails where an instance of a prototype in this box, which may be empty, reaches beyond max_coordinate.
void check_reach(const Aabb& box, const Transform& to_world, const FailPlacing& fail);

/// Drops triangles without area, or not finite, and vertices that no triangle uses, and gives normals that
/// are 0 0 0 their triangle's direction; counts them.
void clean_up(PlacedMesh& placed);

}  // namespace twinray
