// SPDX-License-Identifier: Apache-2.0
// Private: the canonical test of one primitive of a geometry, named by its ids.
#pragma once
#include <compare>
#include <cstdint>

#include "accel/canonical/checked_ray.h"
#include "accel/canonical/sphere.h"
#include "accel/canonical/triangle.h"
#include "core/geometry.h"
#include "core/hit.h"

namespace twinray {

/// A primitive by its ids: shape and index within the shape.
struct PrimitiveId {
  std::uint32_t mesh, primitive;
  friend auto operator<=>(const PrimitiveId&, const PrimitiveId&) = default;
};

/// The box of one primitive.
inline Aabb primitive_bounds(const Geometry& geometry, PrimitiveId id) {
  const Mesh* mesh = geometry.mesh(id.mesh);
  if (!mesh) return sphere_bounds(geometry.sphere_set(id.mesh)->spheres[id.primitive]);
  const auto [a, b, c] = mesh->triangles[id.primitive];
  return triangle_bounds(mesh->positions[a], mesh->positions[b], mesh->positions[c]);
}

/// Whether a hit of a primitive counts, whose shape is not opaque.
inline bool accepts(const Geometry& geometry, const CheckedRay& ray, PrimitiveId id, const ShapeHit& found) {
  return geometry.accepts(ray.origin, ray.direction,
                          {found.t, found.u, found.v, id.primitive, id.mesh, ray.instance});
}

/// The nearest hit of one primitive that counts, in [ray.t_min, t_max]; false for none.
inline bool intersect_primitive(const Geometry& geometry, const CheckedRay& ray, PrimitiveId id, float t_max,
                                ShapeHit& found) {
  if (const Mesh* mesh = geometry.mesh(id.mesh)) {
    const auto [a, b, c] = mesh->triangles[id.primitive];
    return intersect_triangle(ray, mesh->positions[a], mesh->positions[b], mesh->positions[c], t_max,
                              found) &&
           (mesh->is_opaque || accepts(geometry, ray, id, found));
  }
  const SphereSet& set = *geometry.sphere_set(id.mesh);
  return intersect_sphere(ray, set.spheres[id.primitive], t_max, found, [&](const ShapeHit& root) {
    return set.is_opaque || accepts(geometry, ray, id, root);
  });
}

/// Tests one primitive against [ray.t_min, best.t] (a miss in `best` means ray.t_max) and keeps the lesser
/// hit.
inline void test_primitive(const Geometry& geometry, const CheckedRay& ray, PrimitiveId id, Hit& best) {
  ShapeHit found;
  if (!intersect_primitive(geometry, ray, id, std::min(ray.t_max, best.t), found)) return;
  const Hit hit{found.t, found.u, found.v, id.primitive, id.mesh, ray.instance};
  if (precedes(hit, best)) best = hit;
}

}  // namespace twinray
