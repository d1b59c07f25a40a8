// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/scene.h"
#include "integrators/integrator.h"

namespace twinray {

/// The shading normal n of what the camera sees, as the colour (n + 1) / 2; black for nothing. One ray a
/// sample.
class NormalsIntegrator final : public PlainIntegrator {
 public:
  /// Between the corners of a triangle their normals are mixed: the mixture is made a unit vector, or shown
  /// as it is, shorter where the corners' normals differ.
  enum class Mixture { unit, as_it_is };

  /// The scene must outlive the integrator.
  explicit NormalsIntegrator(const Scene& scene, Mixture mixture = Mixture::unit)
      : scene_(scene), mixture_(mixture) {}

  bool is_of_light() const override { return false; }

 private:
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const override;

  const Scene& scene_;
  Mixture mixture_;
};

}  // namespace twinray
