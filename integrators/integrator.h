// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "core/interiors.h"
#include "core/ray.h"
#include "core/ray_cone.h"
#include "core/record.h"
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
  RayCone cone;  ///< Around the ray; without one, textures are seen at points.
  /// How much it counts in the means of its pixel, as the pixel's filter has it; 0: no light comes this way.
  float weight = 1;
  float light = 1;           ///< Its radiance is times that: what the camera's lens leaves of it.
  Interiors interiors = {};  ///< That the ray starts in.
};

/// Estimates the radiance that arrives along camera rays. Immutable: any number of threads may ask.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Writes all layers that are asked for, of as many records as there are samples; a layer that an
  /// integrator knows nothing of becomes black. Each record is a pure function of its sample, whichever
  /// others are made with it and in whatever order their rays are traced.
  virtual void sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                      const RecordSpans& records) const = 0;
  /// Whether that is light, which the camera's lens may dim.
  virtual bool is_of_light() const { return true; }
  /// The radiance of one sample alone.
  Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key, Tracer& tracer) const {
    return radiance({camera_ray, key}, kind, tracer);
  }
  Rgb radiance(const CameraSample& one, SamplerKind kind, Tracer& tracer) const {
    Rgb radiance;
    sample({&one, 1}, kind, tracer, RecordSpans({&radiance, 1}));
    return radiance;
  }
};

/// An integrator that makes its samples one after the other, and knows their radiance alone.
class PlainIntegrator : public Integrator {
 public:
  void sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
              const RecordSpans& records) const final;

 protected:
  virtual Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const = 0;
};

}  // namespace twinray
