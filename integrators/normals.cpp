// SPDX-License-Identifier: Apache-2.0
#include "integrators/normals.h"

#include "core/surface.h"

namespace twinray {

Rgb NormalsIntegrator::radiance_of(const CameraSample& sample, SamplerKind, Tracer& tracer) const {
  const Hit hit = tracer.camera_hit(sample.ray);
  if (hit.is_miss()) return {};
  const Vec3 n = mixture_ == Mixture::unit ? surface_at(*scene_.geometry, hit).shading_normal
                                           : mixed_normal(*scene_.geometry, hit);
  return {0.5f * n.x + 0.5f, 0.5f * n.y + 0.5f, 0.5f * n.z + 0.5f};
}

}  // namespace twinray
