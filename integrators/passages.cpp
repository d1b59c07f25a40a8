// SPDX-License-Identifier: Apache-2.0
#include "integrators/passages.h"

#include <algorithm>
#include <variant>

namespace twinray {

Passages::Passages(const Scene& scene) : scene_(scene) {
  const auto is_passage = [&](const ShapeBinding& binding) {
    return std::holds_alternative<Interface>(scene.materials[binding.material].model);
  };
  if (std::none_of(scene.bindings.begin(), scene.bindings.end(), is_passage)) return;
  for (const ShapeBinding& binding : scene.bindings) is_passage_.push_back(is_passage(binding));
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
  if (!passages_->is_one(hit)) return false;
  if (!way_.goes_on(passages_->scene(), hit.t)) return false;
  through_.pass(hit, way_.ray);
  way_.interiors = through_.interiors();
  way_.hit = Hit{};
  return passed_++ < most_passages;
}

}  // namespace twinray
