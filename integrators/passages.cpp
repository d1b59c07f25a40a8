// SPDX-License-Identifier: Apache-2.0
#include "integrators/passages.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "integrators/interaction.h"

namespace twinray {

Passages::Kind Passages::kind_of(const SurfaceModel& model) {
  if (std::holds_alternative<Interface>(model)) return Kind::interface;
  return std::holds_alternative<Hair>(model) ? Kind::fibre : Kind::none;
}

Passages::Passages(const Scene& scene) : scene_(scene) {
  std::vector<Kind> kinds;
  for (const ShapeBinding& binding : scene.bindings)
    kinds.push_back(kind_of(scene.materials[binding.material].model));
  if (std::any_of(kinds.begin(), kinds.end(), [](Kind kind) { return kind != Kind::none; }))
    kinds_ = std::move(kinds);
}

bool Passages::is_from_within(const Ray& ray, const Hit& hit) const {
  return side_of(surface_at(*scene_.geometry, hit), -ray.direction) == Side::inside;
}

void Passages::follow(Tracer& tracer, Way& way) const {
  PassingRay ray(*this, way);
  for (Hit hit = way.hit; ray.goes_on(hit);) hit = tracer.bounce_hit(ray.ray());
  way = ray.way();
}

Rgb Passages::visibility(Tracer& tracer, const Ray& shadow_ray, const Interiors& interiors) const {
  PassingRay ray(*this, {shadow_ray, {}, interiors});
  while (ray.goes_on(tracer.hit(ray.ray(), RayKind::shadow))) continue;
  return twinray::visibility(scene_, ray.way());
}

bool PassingRay::goes_on(const Hit& hit) {
  way_.hit = hit;
  if (!passages_->is_one(way_.ray, hit)) return false;
  if (!way_.goes_on(passages_->scene(), hit.t)) return false;
  through_.pass(hit, way_.ray);
  way_.interiors = through_.interiors();
  way_.hit = Hit{};
  return passed_++ < most_passages;
}

}  // namespace twinray
