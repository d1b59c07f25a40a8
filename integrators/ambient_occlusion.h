// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

#include "core/bsdf_table.h"
#include "core/scene.h"
#include "integrators/integrator.h"

namespace twinray {

/// Ambient occlusion: how much of a white sky each surface would see if nothing farther away than `distance`
/// were in the way, weighted by the cosine; black for nothing. Two rays a sample. Materials matter by the
/// shading normals that they shape alone.
class AmbientOcclusionIntegrator final : public PlainIntegrator {
 public:
  /// The scene must outlive the integrator. Distance in scene units, > 0.
  explicit AmbientOcclusionIntegrator(const Scene& scene,
                                      float distance = std::numeric_limits<float>::infinity())
      : bsdfs_(scene, Materials::exact), distance_(distance) {}

  bool is_of_light() const override { return false; }

 private:
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const override;

  BsdfTable bsdfs_;
  float distance_;
};

}  // namespace twinray
