// SPDX-License-Identifier: Apache-2.0
#include "integrators/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/offset.h"

namespace twinray {

struct PathIntegrator::State {
  Ray ray;
  Rgb radiance;             ///< Sum of the terms so far.
  Rgb throughput{1, 1, 1};  ///< Product of f |cos| / p of all vertices so far (solid angle), and of roulette.
  int depth = 0;            ///< Scattering events before the current ray.
  bool meets_emission = true;  ///< No direct light estimate has counted what the current ray sees.
};

PathIntegrator::PathIntegrator(const Scene& scene, const PathOptions& options)
    : scene_(scene), options_(options), lights_(scene) {
  if (options.max_depth < 0 || options.max_depth > 100)
    throw Error(fmt::format("the maximum depth is {}; it must lie in [0, 100]", options.max_depth));
  if (options.samples_per_light < 1 || options.samples_per_light > 65536)
    throw Error(fmt::format("{} samples per light; valid are 1 to 65536", options.samples_per_light));
  if (!(options.roulette.continuation >= 0 && options.roulette.continuation <= 1))
    throw Error(fmt::format("the probability of going on is {}; it must lie in (0, 1]",
                            options.roulette.continuation));
}

Rgb PathIntegrator::radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key,
                             Tracer& tracer) const {
  State state{.ray = camera_ray};
  for (;;) {
    const Hit hit = state.depth == 0 ? tracer.camera_hit(state.ray) : tracer.bounce_hit(state.ray);
    if (hit.is_miss()) {
      add_escaped(state);
      break;
    }
    tracer.arrive();
    const SurfacePoint point = surface_at(*scene_.geometry, hit);
    const Vec3 wo = -normalize(state.ray.direction);
    if (state.meets_emission && counts(state.depth))
      state.radiance += state.throughput * lights_.emitted(point, wo);
    if (state.depth >= std::min(options_.max_depth, options_.last_depth)) break;

    const Interaction at(scene_, point, wo);
    VertexSampler sampler(kind, key, std::uint32_t(state.depth) + 1);
    add_direct(state, at, sampler, tracer);
    if (!scatter(state, at, sampler)) break;
  }
  return state.radiance;
}

void PathIntegrator::add_escaped(State& state) const {
  if (!state.meets_emission || !counts(state.depth)) return;
  const Vec3 direction = normalize(state.ray.direction);
  state.radiance +=
      state.throughput * (state.depth == 0 ? lights_.background(direction) : lights_.escaped(direction));
}

void PathIntegrator::add_direct(State& state, const Interaction& at, VertexSampler& sampler,
                                Tracer& tracer) const {
  if (!counts(state.depth + 1) || at.bsdf().is_delta()) return;
  const LightTransport transport{scene_, lights_, options_.direct, options_.samples_per_light};
  state.radiance += state.throughput * direct_light(transport, at, sampler, tracer);
}

bool PathIntegrator::scatter(State& state, const Interaction& at, VertexSampler& sampler) const {
  // The ray behind the last surface could only meet emission that direct light has counted.
  const bool is_last = state.depth + 1 >= std::min(options_.max_depth, options_.last_depth);
  if (is_last && !at.bsdf().has_delta()) return false;
  const float lobe = at.bsdf().has_lobes() ? sampler.draw_1d(Purpose::lobe) : 0;
  const Vec2 direction = sampler.draw_2d(Purpose::direction);
  const auto sample = at.bsdf().sample(at.wo_local(), lobe, direction);
  if (!sample || (is_last && !sample->is_delta)) return false;
  const Vec3 wi = at.to_world(sample->wi);
  if (!at.is_consistent(wi)) return false;
  state.throughput = state.throughput * sample->value * (std::fabs(sample->wi.z) / sample->pdf);
  if (is_black(state.throughput) || (state.depth > 0 && !survives_roulette(state, sampler))) return false;
  state.ray = spawn_ray(at.point(), wi);
  state.meets_emission = sample->is_delta;
  ++state.depth;
  return true;
}

bool PathIntegrator::survives_roulette(State& state, VertexSampler& sampler) const {
  const float chosen = options_.roulette.continuation;
  const float probability = chosen > 0 ? chosen : std::min(1.0f, max_component(state.throughput));
  if (probability >= 1) return true;
  if (sampler.draw_1d(Purpose::roulette) >= probability) return false;
  state.throughput = state.throughput / probability;
  return true;
}

}  // namespace twinray
