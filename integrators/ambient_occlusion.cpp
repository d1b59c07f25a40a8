// SPDX-License-Identifier: Apache-2.0
#include "integrators/ambient_occlusion.h"

#include "core/spawn_ray.h"
#include "core/warp.h"
#include "integrators/interaction.h"

namespace twinray {

Rgb AmbientOcclusionIntegrator::radiance_of(const CameraSample& sample, SamplerKind kind,
                                            Tracer& tracer) const {
  const Hit hit = tracer.camera_hit(sample.ray);
  if (hit.is_miss()) return {};
  tracer.arrive();
  const VertexSampler sampler(kind, PathKey(sample.key), 1);
  SurfacePoint point = surface_at(*bsdfs_.scene().geometry, hit);
  point.texture_draw = sampler.draw_2d(Purpose::texture);
  const Interaction at(bsdfs_, point, -normalize(sample.ray.direction));
  // The density cos / pi cancels the cosine and its integral: each direction counts 1 or 0.
  const Vec2 u = sampler.draw_2d(Purpose::direction);
  const Vec3 towards_sky = at.to_world(square_to_cosine_hemisphere(u));
  if (!at.is_consistent(towards_sky)) return {};
  Ray shadow_ray = spawn_ray(at.point(), towards_sky);
  shadow_ray.t_max = distance_;
  return tracer.visibility(shadow_ray);
}

}  // namespace twinray
