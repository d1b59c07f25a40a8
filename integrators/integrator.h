// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/ray.h"
#include "core/rgb.h"
#include "core/sampler.h"
#include "integrators/tracer.h"

namespace twinray {

/// One sample of a picture: its pixel, and its number within it.
struct PixelSample {
  int x = 0, y = 0;
  std::uint32_t index = 0;
};

/// What it starts with.
struct CameraSample {
  Ray ray;  ///< Its direction need not be a unit vector.
  SampleKey key;
};

/// Estimates the radiance that arrives along a camera ray. Immutable: any number of threads may ask.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// One sample: a pure function of the ray and the key. The ray's direction need not be a unit vector.
  virtual Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key,
                       Tracer& tracer) const = 0;
  /// Many at a time: estimates[i] has the bits of radiance() for samples[i], in whatever order the samples'
  /// rays are traced. Both spans have the same length.
  virtual void radiances(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                         std::span<Rgb> estimates) const {
    for (std::size_t i = 0; i < samples.size(); ++i)
      estimates[i] = radiance(samples[i].ray, kind, samples[i].key, tracer);
  }
};

}  // namespace twinray
