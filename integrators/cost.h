// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "integrators/integrator.h"

namespace twinray {

enum class CostKind { nodes, primitives };

/// What the camera ray took in the accelerator, as a number in all three channels: its inner nodes or its
/// primitives (accel/counters.h). One ray a sample. The tracer must count (RenderOptions::counting); a count
/// beyond Film::max_value is a rejected sample.
class CostIntegrator final : public Integrator {
 public:
  explicit CostIntegrator(CostKind kind) : kind_(kind) {}
  Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key, Tracer& tracer) const override;

 private:
  CostKind kind_;
};

}  // namespace twinray
