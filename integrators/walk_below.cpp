// SPDX-License-Identifier: Apache-2.0
#include "integrators/walk_below.h"

#include <algorithm>

#include "core/frame.h"
#include "core/phase_function.h"
#include "core/spawn_ray.h"
#include "core/surface.h"
#include "core/surface_model.h"
#include "integrators/flight.h"
#include "integrators/interaction.h"

namespace twinray {
namespace {

/// From this step on a walk may be given up: few are so long where much is absorbed.
constexpr std::uint32_t first_roulette = 16;

/// False where the walk is given up.
bool survives(const VertexSampler& draws, Rgb& left) {
  const float probability = std::min(max_component(left), 1.0f);
  if (draws.draw_1d(Purpose::roulette) >= probability) return false;
  left = left / probability;
  return true;
}

/// Goes through a surface within the body.
void pass(const Scene& scene, const SurfacePoint& point, WalkEnd& walk) {
  const Vec3 back = -walk.ray.direction;
  const Material& material = scene.materials[material_at(scene, point)];
  if (lets_light_in(material)) {
    const float ior = ior_of(material.model);
    const float eta = side_of(point, back) == Side::outside ? ior : 1 / ior;
    walk.eta_squared *= eta * eta;
    walk.left = walk.left / (eta * eta);
  }
  walk.interiors = Interaction::interiors_behind(scene, point, back, walk.interiors);
  walk.ray = spawn_ray(point, walk.ray.direction);
}

}  // namespace

std::optional<WalkEnd> walk_below(const Scene& scene, Tracer& tracer, const Interior& medium,
                                  std::uint32_t body, const WalkStart& start, const Rgb& throughput,
                                  const WalkDraws& draws) {
  const PhaseFunction phase(medium.anisotropy);
  WalkEnd walk{.ray = start.into, .left = {1, 1, 1}, .interiors = start.interiors};
  float before = start.way;
  for (std::uint32_t step = 0; step < WalkDraws::most_steps; ++step) {
    const VertexSampler sampler = draws.at(step);
    walk.hit = tracer.bounce_hit(walk.ray);
    if (step == 0 && walk.hit.is_miss() && start.left_if_open) {
      walk.left = *start.left_if_open;
      return walk;
    }
    Flight flight(throughput * walk.left, sampler.draw_1d(Purpose::medium));
    // The medium is even, so it is the same wherever the way begins.
    const Ray whole{.direction = walk.ray.direction};
    const bool is_scattered =
        flight.ends_within(medium, MediumColumn(scene, medium, whole, before + walk.hit.t));
    walk.left = walk.left * flight.weight();
    if (is_black(throughput * walk.left)) return std::nullopt;
    if (is_scattered) {
      ++walk.events;
      const Vec3& direction = walk.ray.direction;
      const Vec3 position = walk.ray.origin + direction * std::max(flight.distance() - before, 0.0f);
      const Vec3 wi = Frame(-direction).to_world(phase.sample(sampler.draw_2d(Purpose::direction)));
      walk.ray = {.origin = position, .direction = wi};
      before = 0;
    } else {
      if (walk.hit.is_miss()) return std::nullopt;
      const SurfacePoint point = surface_at(*scene.geometry, walk.hit);
      if (scene.bindings[point.shape].material == body) return walk;
      pass(scene, point, walk);
      before = 0;
    }
    if (step >= first_roulette && !survives(sampler, walk.left)) return std::nullopt;
  }
  walk.hit = Hit{};
  walk.interiors = start.interiors;
  walk.left = walk.left * walk.eta_squared;
  walk.eta_squared = 1;
  return walk;
}

}  // namespace twinray
