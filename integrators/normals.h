// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/scene.h"
#include "integrators/integrator.h"

namespace twinray {

/// The shading normal n of what the camera sees, as the colour (n + 1) / 2; black for nothing. One ray a
/// sample.
class NormalsIntegrator final : public Integrator {
 public:
  /// The scene must outlive the integrator.
  explicit NormalsIntegrator(const Scene& scene) : scene_(scene) {}
  Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key, Tracer& tracer) const override;

 private:
  const Scene& scene_;
};

}  // namespace twinray
