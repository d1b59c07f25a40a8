// SPDX-License-Identifier: Apache-2.0
// The canonical closest hit by the plainest loop, for tests of core/ that need no accelerator.
#pragma once
#include <optional>

#include "accel/canonical/shape_test.h"

namespace twinray::test {

/// The least accepted hit of all primitives, as every accelerator must give it.
inline Hit trace_all(const Geometry& geometry, const Ray& ray) {
  CheckedRay checked;
  Hit best;
  if (!load_ray(ray, checked)) return best;
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    const Mesh* mesh = geometry.mesh(shape);
    const std::size_t count = mesh ? mesh->triangles.size() : geometry.sphere_set(shape)->spheres.size();
    for (std::uint32_t i = 0; i < count; ++i) test_primitive(geometry, checked, {shape, i}, best);
  }
  best.t = float(best.t * checked.t_scale);
  return best;
}

/// The canonical hit of one triangle, t in units of the caller's direction.
inline std::optional<ShapeHit> trace_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  CheckedRay checked;
  ShapeHit hit;
  if (!load_ray(ray, checked) || !intersect_triangle(checked, a, b, c, checked.t_max, hit)) return {};
  hit.t = float(hit.t * checked.t_scale);
  return hit;
}

/// The canonical hit of one sphere.
inline std::optional<ShapeHit> trace_sphere(const Ray& ray, const Sphere& sphere) {
  CheckedRay checked;
  ShapeHit hit;
  if (!load_ray(ray, checked) || !intersect_sphere(checked, sphere, checked.t_max, hit)) return {};
  hit.t = float(hit.t * checked.t_scale);
  return hit;
}

}  // namespace twinray::test
