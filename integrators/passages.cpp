// SPDX-License-Identifier: Apache-2.0
#include "integrators/passages.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/spawn_ray.h"
#include "integrators/interaction.h"

namespace twinray {
namespace {

/// Whoever passes more is lost between surfaces that lie in each other.
constexpr int most_passages = 10000;

float length_to(const Ray& ray, float t) { return (t - ray.t_min) * length(ray.direction); }

/// The rest of a path's ray.
Ray rest_of_path(const SurfacePoint& point, const Ray& ray, float t) {
  return {.origin = leave_surface(point, ray.direction), .direction = ray.direction, .t_max = ray.t_max - t};
}

/// The rest of a shadow ray, which ends where that does: before the light's surface.
Ray rest_of_shadow(const SurfacePoint& point, const Ray& ray, float t) {
  if (!std::isfinite(ray.t_max)) return rest_of_path(point, ray, t);
  const Vec3 origin = leave_surface(point, ray.direction);
  return {.origin = origin, .direction = ray.origin + ray.direction * ray.t_max - origin, .t_max = 1};
}

}  // namespace

Passages::Passages(const Scene& scene) : scene_(scene) {
  const auto is_passage = [&](const ShapeBinding& binding) {
    return std::holds_alternative<Interface>(scene.materials[binding.material].model);
  };
  if (std::none_of(scene.bindings.begin(), scene.bindings.end(), is_passage)) return;
  for (const ShapeBinding& binding : scene.bindings) is_passage_.push_back(is_passage(binding));
}

template <typename Behind>
void Passages::pass(Tracer& tracer, Way& way, RayKind kind, const Behind& behind) const {
  for (int passed = 0; is_one(way.hit); ++passed) {
    const SurfacePoint point = surface_at(*scene_.geometry, way.hit);
    const float distance = length_to(way.ray, way.hit.t);
    way.left = way.left * transmittance(scene_.materials, way.interiors, distance);
    way.cone = way.cone.at(distance);
    way.interiors = Interaction::interiors_behind(scene_, point, -way.ray.direction, way.interiors);
    way.ray = behind(point, way.ray, way.hit.t);
    const bool goes_on = passed < most_passages && length_squared(way.ray.direction) > 0 && way.ray.t_max > 0;
    way.hit = goes_on ? tracer.hit(way.ray, kind) : Hit{};
  }
}

void Passages::follow(Tracer& tracer, Way& way) const { pass(tracer, way, RayKind::bounce, rest_of_path); }

Rgb Passages::visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const {
  Way way{shadow_ray, tracer.hit(shadow_ray, RayKind::shadow), interiors};
  pass(tracer, way, RayKind::shadow, rest_of_shadow);
  if (!way.hit.is_miss()) return {};
  return way.left * transmittance(scene_.materials, way.interiors, length_to(way.ray, way.ray.t_max));
}

}  // namespace twinray
