// SPDX-License-Identifier: Apache-2.0
#include "integrators/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/error.h"
#include "core/spawn_ray.h"

namespace twinray {

constexpr int first_bounce_at_risk = 2;
/// Light of three bounces is much of a room's: paths that end before they bring it cost more noise than they
/// save time.
constexpr int first_bounce_at_risk_by_throughput = 4;

/// A path that goes on, but for its ray.
struct PathIntegrator::Path {
  PathKey key;
  Rgb* radiance;            ///< Sum of the terms so far.
  Rgb throughput{1, 1, 1};  ///< Product of f |cos| / p of all vertices so far (solid angle), and of roulette.
};

/// Paths with the same number of vertices.
struct PathIntegrator::Wave {
  SamplerKind kind;
  DirectLight direct;
  int depth = 0;  ///< Scattering events before the current rays.
  std::vector<Path> paths;
  std::vector<Ray> rays;  ///< Of each path.
  std::vector<Hit> hits;
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
  const CameraSample sample{camera_ray, key};
  Rgb estimate;
  radiances({&sample, 1}, kind, tracer, {&estimate, 1});
  return estimate;
}

void PathIntegrator::radiances(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                               std::span<Rgb> estimates) const {
  const LightTransport transport{scene_, lights_, options_.direct, options_.samples_per_light};
  Wave wave{.kind = kind, .direct = DirectLight(transport)};
  wave.paths.reserve(samples.size());
  wave.rays.reserve(samples.size());
  wave.hits.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    estimates[i] = {};
    wave.paths.push_back({PathKey(samples[i].key), &estimates[i]});
    wave.rays.push_back(samples[i].ray);
  }
  tracer.camera_hits(wave.rays, wave.hits);
  advance(wave, tracer);
  while (!wave.paths.empty()) {
    tracer.bounce_hits(wave.rays, wave.hits);
    advance(wave, tracer);
  }
}

void PathIntegrator::advance(Wave& wave, Tracer& tracer) const {
  tracer.arrive();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < wave.paths.size(); ++i) {
    if (!visit(wave, wave.paths[i], wave.rays[i], wave.hits[i], tracer)) continue;
    wave.paths[kept] = wave.paths[i];
    wave.rays[kept++] = wave.rays[i];
  }
  wave.direct.finish(tracer);
  wave.paths.resize(kept);
  wave.rays.resize(kept);
  wave.hits.resize(kept);
  ++wave.depth;
}

bool PathIntegrator::visit(Wave& wave, Path& path, Ray& ray, const Hit& hit, Tracer& tracer) const {
  const Vec3 direction = normalize(ray.direction);
  if (hit.is_miss()) {
    add_escaped(wave, path, direction);
    return false;
  }
  const SurfacePoint point = surface_at(*scene_.geometry, hit);
  const Vec3 wo = -direction;
  // Behind the first surface direct light has counted what a ray hits.
  if (wave.depth == 0 && counts(0)) *path.radiance += path.throughput * lights_.emitted(point, wo);
  if (wave.depth >= depth_limit()) return false;

  const Interaction at(scene_, point, wo);
  VertexSampler sampler(wave.kind, path.key, std::uint32_t(wave.depth) + 1);
  if (counts(wave.depth + 1)) wave.direct.draw(at, path.throughput, sampler, tracer, *path.radiance);
  return scatter(wave, path, ray, at, sampler);
}

void PathIntegrator::add_escaped(const Wave& wave, const Path& path, const Vec3& direction) const {
  if (wave.depth == 0 && counts(0)) *path.radiance += path.throughput * lights_.background(direction);
}

bool PathIntegrator::scatter(const Wave& wave, Path& path, Ray& ray, const Interaction& at,
                             VertexSampler& sampler) const {
  // The ray after the last surface could only hit emission that direct light has counted.
  if (wave.depth + 1 >= depth_limit()) return false;
  const Vec2 direction = sampler.draw_2d(Purpose::direction);
  const BsdfSample sample = at.bsdf().sample(at.wo_local(), direction);
  if (sample.pdf == 0) return false;
  const Vec3 wi = at.to_world(sample.wi);
  if (!at.is_consistent(wi)) return false;
  path.throughput = path.throughput * sample.value * (std::fabs(sample.wi.z) / sample.pdf);
  if (is_black(path.throughput) || !survives_roulette(path, wave.depth + 1, sampler)) return false;
  ray = spawn_ray(at.point(), wi);
  return true;
}

bool PathIntegrator::survives_roulette(Path& path, int bounce, VertexSampler& sampler) const {
  const float chosen = options_.roulette.continuation;
  if (bounce < (chosen > 0 ? first_bounce_at_risk : first_bounce_at_risk_by_throughput)) return true;
  const float probability = chosen > 0 ? chosen : std::min(1.0f, max_component(path.throughput));
  if (probability >= 1) return true;
  if (sampler.draw_1d(Purpose::roulette) >= probability) return false;
  path.throughput = path.throughput / probability;
  return true;
}

}  // namespace twinray
