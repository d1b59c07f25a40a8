// SPDX-License-Identifier: Apache-2.0
// Private: the first stage of a wave.
#pragma once
#include <optional>
#include <span>
#include <string>

#include "core/camera.h"
#include "core/filter_sampler.h"
#include "integrators/integrator.h"
#include "integrators/wave/stages.h"

namespace twinray {

/// Of what the samples are.
struct CameraSampling {
  int width = 0, height = 0;  ///< Of the full frame, in pixels.
  std::uint32_t samples = 1;  ///< Per pixel.
  SamplerKind kind = SamplerKind::sobol;
  std::uint64_t seed = 0;
  PixelFilter filter;
};

/// Makes the camera rays of samples: through the pixel's centre where it has one sample, else through random
/// points of the pixel's filter, from random points of the lens.
class CameraStage {
 public:
  /// The camera is that of the whole frame; `simd` is one of available_instruction_sets(). Throws Error for
  /// a filter out of range.
  CameraStage(const Camera& camera, const CameraSampling& sampling, const std::string& simd = "best");
  /// made[i] is that of samples[i].
  void make(std::span<const PixelSample> samples, std::span<CameraSample> made) const;

 private:
  struct Draws;
  static Draws& draws_of_this_thread();
  SampleKey key_of(const PixelSample& sample) const {
    return {sampling_.seed, std::uint32_t(sample.x), std::uint32_t(sample.y), sample.index};
  }
  Vec2 frame_point(const PixelSample& sample, Vec2 in_pixel) const {
    return {(float(sample.x) + in_pixel.x) / float(sampling_.width),
            (float(sample.y) + in_pixel.y) / float(sampling_.height)};
  }
  CameraSample sample_of(const LensRay& made, const PixelSample& sample, float weight) const {
    return {made.ray, key_of(sample), pixel_cone_.part(part_of_pixel(sample.index)),
            made.ray.t_max < made.ray.t_min ? 0 : weight, made.light};
  }
  /// From a point of the frame and of the lens, the latter by a draw.
  CameraSample sample_at(const PixelSample& sample, const FilterSampler::Place& place, Vec2 u) const {
    return sample_of(lens_ray(camera_, frame_point(sample, place.in_pixel), u), sample, place.weight);
  }
  CameraSample make_alone(const PixelSample& sample) const;
  /// The draws of up to wave_size samples.
  void draw(std::span<const PixelSample> samples, Draws& draws) const;
  void make_together(std::span<const PixelSample> samples, std::span<CameraSample> made) const;
  /// Whether lanes know the directions of all rays.
  bool is_pinhole() const {
    return camera_.projection == Projection::perspective && !has_lens(camera_) && !camera_.clips_by_distance;
  }
  void make_of_pinhole(std::span<const PixelSample> samples, Draws& draws,
                       std::span<CameraSample> made) const;

  const Camera camera_;
  const CameraSampling sampling_;
  const FilterSampler filter_;
  const RayCone pixel_cone_;
  const std::optional<WaveStages> stages_;
};

}  // namespace twinray
