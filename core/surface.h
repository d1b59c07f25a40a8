// SPDX-License-Identifier: Apache-2.0
// The step after a query: what the small Hit means.
#pragma once
#include "core/geometry.h"
#include "core/hit.h"
#include "core/vec.h"

namespace twinray {

/// A point of a surface.
struct SurfacePoint {
  /// From the hit's weights, not from the ray: on the exact surface but for rounding, which `offset` covers.
  /// Within the triangle, at least 8 offsets away from its edges where it has room (core/surface.cpp).
  Vec3 position;
  Vec3 geometric_normal;  ///< Unit; out of the front of a triangle, outward for a sphere.
  Vec3 shading_normal;  ///< Unit; the file's, interpolated, on whichever side that has it, else the geometric
                        ///< one.
  Vec2 uv;              ///< Texture coordinates; a mesh without has the hit's weights.
  Vec2 second_uv;       ///< Those of the second set; a mesh without has the same again.
  float offset =
      0;  ///< How far along the geometric normal a ray must start to leave the surface (core/offset.h).
  std::uint32_t shape = 0;
  std::uint32_t primitive = 0;           ///< The triangle or sphere of the shape.
  std::uint32_t instance = no_instance;  ///< Of which the shape is; all above is in the scene's space.
  // What a path adds, where textures are looked up:
  float footprint = 0;            ///< how wide, in texture coordinates, what it sees is (core/ray_cone.h),
  float second_footprint = 0;     ///< by the second set, too,
  float width = 0;                ///< and in the scene,
  Vec2 texture_draw{0.5f, 0.5f};  ///< and what chooses pixels of pictures at random, in [0, 1)^2.
};

/// Expands a hit (not a miss) of this geometry.
SurfacePoint surface_at(const Geometry& geometry, const Hit& hit);

/// The texture coordinates of a hit: of a mesh without, and of a sphere, the hit's u and v.
Vec2 texture_coordinates(const Geometry& geometry, const Hit& hit, CoordinateSet set = CoordinateSet::first);

/// The normals of the triangle's corners mixed by the hit's weights, of whatever length; without such normals
/// the geometric one. Of a sphere its unit normal. Of an instance that of a copy: each corner's normal, as a
/// unit vector, is taken into the scene before they are mixed.
Vec3 mixed_normal(const Geometry& geometry, const Hit& hit);

/// A point of a triangle by the weights of its second and third vertex, without the mesh's normals and
/// texture coordinates: for the rest, the same as surface_at gives.
SurfacePoint triangle_point(const Geometry& geometry, std::uint32_t shape, std::uint32_t triangle, float u,
                            float v);
/// A point of a sphere by its unit normal.
SurfacePoint sphere_point(const Sphere& sphere, std::uint32_t shape, const Vec3& normal);

}  // namespace twinray
