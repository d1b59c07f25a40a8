// SPDX-License-Identifier: Apache-2.0
#include "integrators/walk_below.h"

#include <algorithm>

#include "core/frame.h"
#include "core/phase_function.h"
#include "core/spawn_ray.h"
#include "core/surface.h"
#include "integrators/flight.h"

namespace twinray {
namespace {

/// From this event on a walk may be given up: few are so long where much is absorbed.
constexpr std::uint32_t first_roulette = 16;

/// False where the walk is given up.
bool survives(const VertexSampler& draws, Rgb& left) {
  const float probability = std::min(max_component(left), 1.0f);
  if (draws.draw_1d(Purpose::roulette) >= probability) return false;
  left = left / probability;
  return true;
}

}  // namespace

std::optional<WalkEnd> walk_below(const Scene& scene, Tracer& tracer, const Interior& medium,
                                  std::uint32_t body, const Ray& into, const Rgb& throughput,
                                  const WalkDraws& draws) {
  const PhaseFunction phase(medium.anisotropy);
  WalkEnd end{.ray = into, .left = {1, 1, 1}};
  for (std::uint32_t step = 0; step < WalkDraws::most_events; ++step) {
    const VertexSampler sampler = draws.at(step);
    end.hit = tracer.bounce_hit(end.ray);
    Flight flight(throughput * end.left, sampler.draw_1d(Purpose::medium));
    const bool is_scattered = flight.ends_within(medium, MediumColumn(scene, medium, end.ray, end.hit.t));
    end.left = end.left * flight.weight();
    if (is_black(throughput * end.left)) return std::nullopt;
    const Vec3& direction = end.ray.direction;
    if (is_scattered) {
      ++end.events;
      const Vec3 wi = Frame(-direction).to_world(phase.sample(sampler.draw_2d(Purpose::direction)));
      end.ray = {.origin = end.ray.origin + direction * flight.distance(), .direction = wi};
    } else {
      if (end.hit.is_miss()) return std::nullopt;
      const SurfacePoint point = surface_at(*scene.geometry, end.hit);
      if (scene.bindings[point.shape].material == body) return end;
      end.ray = spawn_ray(point, direction);
    }
    if (step >= first_roulette && !survives(sampler, end.left)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace twinray
