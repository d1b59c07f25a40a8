// SPDX-License-Identifier: Apache-2.0
#include "integrators/emergence.h"

#include <algorithm>
#include <cmath>

#include "core/subsurface.h"
#include "integrators/seen_point.h"

namespace twinray {
namespace {

Rgb at_least(const Rgb& color, float least) {
  return {std::max(color.r, least), std::max(color.g, least), std::max(color.b, least)};
}

}  // namespace

bool goes_below(const Scene& scene, const Interaction& at) {
  const Material& material = scene.materials[at.material()];
  if (!has_subsurface(material)) return false;
  if (max_component(material.subsurface.radius) < least_radius * at.point().offset) return false;
  if (at.side() == Side::outside) return true;
  // Nothing but a walk gets into a body that is opaque: mostly its surface is turned inside out.
  const ShapeBinding& binding = scene.bindings[at.point().shape];
  return binding.material == at.material() && binding.alpha == no_texture && !lets_light_in(material);
}

WalkBelow walk_from(const Scene& scene, const Interaction& from, const Ray& into, const Interiors& interiors,
                    const Rgb& throughput, const WalkDraws& draws) {
  const SurfacePoint& in = from.point();
  Subsurface below = scene.materials[from.material()].subsurface;
  below.radius = at_least(below.radius, least_radius * in.offset);
  // The way to the ray's origin, as steep as it mostly is.
  const float cosine = std::fabs(dot(in.geometric_normal, into.direction));
  const Rgb reflectance = from.reflectance_below();
  WalkStart start{into, in.offset / std::max(cosine, 0.25f), interiors};
  if (from.side() == Side::inside) start.left_if_open = reflectance;
  const BodyBelow body{medium_below(below, reflectance), scene.bindings[in.shape].material};
  return {scene, body, start, throughput, draws};
}

Interaction come_out(const BsdfTable& bsdfs, const Interaction& from, const WalkEnd& end,
                     const VertexSampler& draws, Materials materials, RayCone& cone) {
  const bool is_back = end.hit.is_miss();
  const Vec3& direction = end.ray.direction;
  return Interaction::emerging(
      bsdfs, is_back ? from.point() : seen_point(bsdfs.scene(), end.hit, direction, draws, cone),
      from.material(), is_back ? from.wo() : normalize(direction), {materials, end.interiors});
}

}  // namespace twinray
