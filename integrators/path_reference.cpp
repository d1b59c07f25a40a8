// SPDX-License-Identifier: Apache-2.0
#include "integrators/path_reference.h"

#include <cmath>

#include "core/spawn_ray.h"
#include "integrators/direct_light.h"

namespace twinray {

PathReference::PathReference(const Scene& scene, const PathOptions& options)
    : scene_(scene), options_(options), lights_(scene) {
  check(options);
}

Rgb PathReference::radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key,
                            Tracer& tracer) const {
  const LightTransport transport{scene_, lights_, options_.direct, options_.samples_per_light};
  const PathKey path(key);
  Rgb radiance;
  Rgb throughput{1, 1, 1};  // Product of f |cos| / p of all vertices so far (solid angle), and of roulette.
  Ray ray = camera_ray;
  Hit hit = tracer.camera_hit(ray);
  for (int depth = 0;; ++depth) {  // Scattering events before the current ray.
    tracer.arrive();
    const Vec3 direction = normalize(ray.direction);
    const bool sees_emission = depth == 0 && options_.counts(0);
    if (hit.is_miss()) {
      if (sees_emission) radiance += throughput * lights_.background(direction);
      return radiance;
    }
    const SurfacePoint point = surface_at(*scene_.geometry, hit);
    if (sees_emission) radiance += throughput * lights_.emitted(point, -direction);
    if (depth >= options_.depth_limit()) return radiance;

    const Interaction at(scene_, point, -direction);
    const VertexSampler sampler(kind, path, std::uint32_t(depth) + 1);
    if (options_.counts(depth + 1)) radiance += throughput * direct_light(transport, at, sampler, tracer);
    // The ray after the last surface could only hit emission that direct light has counted.
    if (depth + 1 >= options_.depth_limit() || !scatter(at, depth, sampler, throughput, ray)) return radiance;
    hit = tracer.bounce_hit(ray);
  }
}

bool PathReference::scatter(const Interaction& at, int depth, const VertexSampler& sampler, Rgb& throughput,
                            Ray& ray) const {
  const BsdfSample sample = at.bsdf().sample(at.wo_local(), sampler.draw_2d(Purpose::direction));
  if (sample.pdf == 0) return false;
  const Vec3 wi = at.to_world(sample.wi);
  if (!at.is_consistent(wi)) return false;
  throughput = throughput * sample.value * (std::fabs(sample.wi.z) / sample.pdf);
  if (is_black(throughput) || !survives_roulette(depth + 1, sampler, throughput)) return false;
  ray = spawn_ray(at.point(), wi);
  return true;
}

bool PathReference::survives_roulette(int bounce, const VertexSampler& sampler, Rgb& throughput) const {
  if (!options_.roulette.applies(bounce)) return true;
  const float probability = options_.roulette.probability(throughput);
  if (probability >= 1) return true;
  if (sampler.draw_1d(Purpose::roulette) >= probability) return false;
  throughput = throughput / probability;
  return true;
}

}  // namespace twinray
