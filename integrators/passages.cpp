// SPDX-License-Identifier: Apache-2.0
#include "integrators/passages.h"

#include <algorithm>
#include <variant>

#include "integrators/straight_on.h"

namespace twinray {
namespace {

/// Whoever passes more is lost between surfaces that lie in each other.
constexpr int most_passages = 10000;

}  // namespace

Passages::Passages(const Scene& scene) : scene_(scene) {
  const auto is_passage = [&](const ShapeBinding& binding) {
    return std::holds_alternative<Interface>(scene.materials[binding.material].model);
  };
  if (std::none_of(scene.bindings.begin(), scene.bindings.end(), is_passage)) return;
  for (const ShapeBinding& binding : scene.bindings) is_passage_.push_back(is_passage(binding));
}

void Passages::pass(Tracer& tracer, Way& way, RayKind kind) const {
  StraightOn through(scene_, way.interiors);
  for (int passed = 0; is_one(way.hit); ++passed) {
    if (!way.goes_on(scene_, way.hit.t)) return;
    through.pass(way.hit, way.ray);
    way.interiors = through.interiors();
    way.hit = passed < most_passages ? tracer.hit(way.needed_ray(scene_), kind) : Hit{};
  }
}

void Passages::follow(Tracer& tracer, Way& way) const { pass(tracer, way, RayKind::bounce); }

Rgb Passages::follow_to_end(Tracer& tracer, Way& way) const {
  follow(tracer, way);
  if (!way.is_scattered) way.goes_on(scene_, way.hit.t);
  return way.weight();
}

Rgb Passages::visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const {
  Way way{shadow_ray, tracer.hit(shadow_ray, RayKind::shadow), interiors};
  pass(tracer, way, RayKind::shadow);
  if (!way.hit.is_miss()) return {};
  way.goes_on(scene_, way.ray.t_max);
  return way.left;
}

}  // namespace twinray
