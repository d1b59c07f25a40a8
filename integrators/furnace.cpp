// SPDX-License-Identifier: Apache-2.0
#include "integrators/furnace.h"

#include "core/spawn_ray.h"
#include "integrators/scattering.h"

namespace twinray {

Rgb FurnaceIntegrator::radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const {
  const PathKey path_key(sample.key);
  Viewing viewing{.interiors = sample.interiors};
  Ray ray = sample.ray;
  Hit hit = tracer.camera_hit(ray);
  Rgb throughput =
      transmittance(bsdfs_.scene().materials, viewing.interiors, (hit.t - ray.t_min) * length(ray.direction));
  for (int depth = 0; !hit.is_miss(); ++depth) {
    if (depth == max_depth_) return {};
    tracer.arrive();
    const VertexSampler sampler(kind, path_key, std::uint32_t(depth) + 1);
    SurfacePoint point = surface_at(*bsdfs_.scene().geometry, hit);
    point.texture_draw = sampler.draw_2d(Purpose::texture);
    const Interaction at(bsdfs_, point, -normalize(ray.direction), viewing);
    const float lobe = sampler.draw_1d(Purpose::lobe);
    const Vec2 u = sampler.draw_2d(Purpose::direction);
    const auto next = scatter(at, throughput, lobe, u);
    if (!next) return {};
    viewing.interiors = next->interiors;
    ray = spawn_ray(at.point(), next->direction);
    hit = tracer.bounce_hit(ray);
    throughput = next->throughput * transmittance(bsdfs_.scene().materials, viewing.interiors, hit.t);
  }
  return throughput;
}

}  // namespace twinray
