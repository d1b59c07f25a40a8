// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "integrators/integrator.h"

namespace twinray {

enum class CostKind { nodes, primitives };

/// What the camera ray took in the accelerator, as a number in all three channels: its inner nodes or its
/// primitives (accel/counters.h). One ray a sample. The tracer must count (RenderOptions::counting); a count
/// beyond Film::max_value is a rejected sample.
class CostIntegrator final : public PlainIntegrator {
 public:
  explicit CostIntegrator(CostKind kind) : kind_(kind) {}

  bool is_of_light() const override { return false; }

 private:
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const override;

  CostKind kind_;
};

}  // namespace twinray
