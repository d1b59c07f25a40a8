// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/ray.h"
#include "core/rgb.h"
#include "core/sampler.h"
#include "integrators/tracer.h"

namespace twinray {

/// Estimates the radiance that arrives along a camera ray. Immutable: any number of threads may ask.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// One sample: a pure function of the ray and the key. The ray's direction need not be a unit vector.
  virtual Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key,
                       Tracer& tracer) const = 0;
};

}  // namespace twinray
