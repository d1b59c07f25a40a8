// SPDX-License-Identifier: Apache-2.0
#include "integrators/camera_interiors.h"

#include <algorithm>

#include "integrators/straight_on.h"

namespace twinray {
namespace {

/// Ways along it seldom lie in a surface: it is parallel to no axis, and to no side of a box.
constexpr Vec3 aslant{0.283f, 0.867f, 0.41f};
/// A way that crosses more surfaces is given up: nothing is known to be around its end.
constexpr int most_crossings = 10000;

/// Of a mix, that is as if it had one.
bool may_have_interior(const Scene& scene, std::uint32_t shape) {
  const Material& material = scene.materials[scene.bindings[shape].material];
  return has_interior(material) || std::holds_alternative<Mix>(material.model);
}

Aabb bounds_of_bodies(const Scene& scene) {
  const Geometry& geometry = *scene.geometry;
  Aabb box;
  if (std::none_of(scene.materials.begin(), scene.materials.end(), has_interior)) return box;
  const ShapeRange direct = geometry.direct_shapes();
  for (std::uint32_t shape = direct.first; shape < direct.end(); ++shape)
    if (may_have_interior(scene, shape)) box.extend(geometry.bounds(shape));
  for (std::uint32_t i = 0; i < geometry.instances().size(); ++i) {
    const ShapeRange shown = geometry.prototypes()[geometry.instances()[i].prototype];
    for (std::uint32_t shape = shown.first; shape < shown.end(); ++shape)
      if (may_have_interior(scene, shape)) box.extend(geometry.placed()[i].box);
  }
  return box;
}

/// Whether all rays start where the camera stands.
bool is_one_point(const Camera& camera) {
  return camera.projection != Projection::orthographic && !has_lens(camera) && camera.clip_near == 0;
}

}  // namespace

CameraInteriors::CameraInteriors(const Scene& scene, const Accelerator& accelerator, const Camera& camera)
    : scene_(scene), accelerator_(accelerator), bodies_(bounds_of_bodies(scene)) {
  if (is_one_point(camera)) of_all_ = at(camera.position);
}

void CameraInteriors::find(std::span<CameraSample> samples) const {
  if (bodies_.is_empty() && scene_.atmosphere == no_material) return;
  for (CameraSample& sample : samples) {
    const Ray& ray = sample.ray;
    sample.interiors = of_all_ ? *of_all_ : at(ray.origin + ray.direction * ray.t_min);
  }
}

Interiors CameraInteriors::at(const Vec3& point) const {
  if (!bodies_.contains(Aabb{point, point})) return around_all();
  return along(aslant, point).shared_with(along(-aslant, point));
}

Interiors CameraInteriors::around_all() const {
  Interiors interiors;
  if (scene_.atmosphere != no_material) interiors.enter(scene_.atmosphere);
  return interiors;
}

Interiors CameraInteriors::along(const Vec3& direction, const Vec3& point) const {
  const Vec3 way = direction * (2 * length(accelerator_.bounds().extent()));
  Ray ray{.origin = point - way, .direction = way, .t_max = 1};
  StraightOn through(scene_, around_all());
  for (int crossings = 0; crossings < most_crossings; ++crossings) {
    const Hit hit = accelerator_.closest_hit(ray);
    if (hit.is_miss()) return through.interiors();
    through.pass(hit, ray);
  }
  return around_all();
}

}  // namespace twinray
