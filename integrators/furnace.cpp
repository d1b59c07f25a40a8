// SPDX-License-Identifier: Apache-2.0
#include "integrators/furnace.h"

#include "core/spawn_ray.h"
#include "integrators/scattering.h"

namespace twinray {

Rgb FurnaceIntegrator::radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const {
  const PathKey path_key(sample.key);
  const Scene& scene = bsdfs_.scene();
  Viewing viewing{.interiors = sample.interiors};
  Way way{sample.ray, tracer.camera_hit(sample.ray), sample.interiors};
  Rgb throughput{1, 1, 1};
  VertexSampler sampler(kind, path_key, 0);
  for (int depth = 0;; ++depth) {
    if (has_flights_) way.flight.emplace(throughput, sampler.draw_1d(Purpose::medium));
    way.goes_on(scene, way.hit.t);
    throughput = throughput * way.weight();
    if (way.hit.is_miss() && !way.is_scattered) return throughput;
    if (depth == max_depth_) return {};
    tracer.arrive();
    sampler = VertexSampler(kind, path_key, std::uint32_t(depth) + 1);
    const Interaction at = arrive(way, sampler, viewing);
    const float lobe = sampler.draw_1d(Purpose::lobe);
    const Vec2 u = sampler.draw_2d(Purpose::direction);
    const auto next = scatter(at, throughput, lobe, u);
    if (!next) return {};
    throughput = next->throughput;
    viewing.interiors = next->interiors;
    const Ray ray = spawn_ray(at.point(), next->direction);
    way = {ray, tracer.bounce_hit(ray), viewing.interiors};
  }
}

Interaction FurnaceIntegrator::arrive(const Way& way, const VertexSampler& sampler,
                                      const Viewing& viewing) const {
  const Scene& scene = bsdfs_.scene();
  const Vec3 wo = -normalize(way.ray.direction);
  if (way.is_scattered) return Interaction::in_medium(scene, way.scattered_at(), wo, viewing);
  SurfacePoint point = surface_at(*scene.geometry, way.hit);
  point.texture_draw = sampler.draw_2d(Purpose::texture);
  return {bsdfs_, point, wo, viewing};
}

}  // namespace twinray
