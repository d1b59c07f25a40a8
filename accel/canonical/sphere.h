// SPDX-License-Identifier: Apache-2.0
// Private: the canonical ray-sphere test.
//
// The quadratic is solved in double around the point of the ray closest to the centre, so that neither a far
// origin nor a tangent ray loses the roots to cancellation. The nearer root that lies in the interval is the
// hit: the far one for an origin inside, or where t_min lies beyond the near one.
#pragma once
#include <cmath>

#include "accel/canonical/triangle.h"
#include "core/octahedron.h"

namespace twinray {

/// The nearest hit of a ray with a sphere in the closed interval [ray.t_min, t_max] that `accepts` accepts;
/// false for none. u, v: the octahedral normal of the point.
template <typename Accepts>
bool intersect_sphere(const CheckedRay& ray, const Sphere& sphere, float t_max, ShapeHit& hit,
                      const Accepts& accepts) {
  if (!(sphere.radius > 0)) return false;
  const double dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
  const double ox = double(ray.origin.x) - sphere.center.x, oy = double(ray.origin.y) - sphere.center.y,
               oz = double(ray.origin.z) - sphere.center.z;
  const double dd = dx * dx + dy * dy + dz * dz;
  const double closest = -(ox * dx + oy * dy + oz * dz) / dd;
  const double cx = ox + closest * dx, cy = oy + closest * dy, cz = oz + closest * dz;
  const double room = double(sphere.radius) * sphere.radius - (cx * cx + cy * cy + cz * cz);
  if (room < 0) return false;
  const double half_chord = std::sqrt(room / dd);
  const Aabb bounds = sphere_bounds(sphere);
  for (const double h : {-half_chord, half_chord}) {
    hit.t = float(closest + h);
    if (!clamp_to_box(ray, bounds, t_max, hit.t)) continue;
    const Vec2 uv = octahedral_encode(cx + h * dx, cy + h * dy, cz + h * dz);
    hit.u = uv.x;
    hit.v = uv.y;
    if (accepts(hit)) return true;
  }
  return false;
}

/// The same of all hits.
inline bool intersect_sphere(const CheckedRay& ray, const Sphere& sphere, float t_max, ShapeHit& hit) {
  return intersect_sphere(ray, sphere, t_max, hit, [](const ShapeHit&) { return true; });
}

}  // namespace twinray
