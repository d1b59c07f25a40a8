// SPDX-License-Identifier: Apache-2.0
#include "integrators/sample_maker.h"

#include <algorithm>

#include "core/visible_pixels.h"

namespace twinray {
namespace {

/// The pixels through which a camera ray may see something; all, where the background shines.
PixelRect pixels_with_light(const TracedScene& of, const Camera& camera, const RenderOptions& options) {
  const auto is_behind_all = [](const Light& light) { return is_background(light.source); };
  if (std::any_of(of.scene.lights.begin(), of.scene.lights.end(), is_behind_all)) return window_of(options);
  const Vec2& radius = options.filter.radius;
  return visible_pixels(
      camera, of.accelerator.bounds(),
      {options.width, options.height, window_of(options), {radius.x + 0.5f, radius.y + 0.5f}});
}

/// What comes along a ray that no light gets through the lens by need not be looked for.
void skip_dark(std::span<CameraSample> samples) {
  for (CameraSample& sample : samples)
    if (sample.light == 0) sample.ray.t_max = -1;
}

}  // namespace

SampleMaker::SampleMaker(const TracedScene& of, const RenderOptions& options)
    : of_(of),
      sampler_(options.sampler),
      camera_(fit_frame(of.scene.camera, options.width, options.height)),
      camera_stage_(
          camera_,
          {options.width, options.height, options.samples, options.sampler, options.seed, options.filter},
          options.simd),
      camera_interiors_(of.scene, of.accelerator, camera_),
      visible_pixels_(pixels_with_light(of, camera_, options)) {}

/// Where all lights are of one group, that has all of the radiance: nothing is divided.
void SampleMaker::sample_lights(std::span<const CameraSample> camera_samples, Tracer& tracer,
                                const RecordSpans& records) const {
  RecordSpans asked = records;
  const PartRows& groups = records[Division::groups];
  const bool is_one_group = !groups.empty() && groups[0].size() == 1;
  if (is_one_group) asked[Division::groups] = {};
  of_.integrator.sample(camera_samples, sampler_, tracer, asked);
  if (!is_one_group) return;
  for (std::size_t i = 0; i < records.color().size(); ++i) groups[i].front() = records.color()[i];
}

void SampleMaker::make(std::span<const PixelSample> samples, std::span<CameraSample> camera_samples,
                       Tracer& tracer, const RecordSpans& records) const {
  camera_stage_.make(samples, camera_samples);
  const bool is_dimmed = camera_.lenses && of_.integrator.is_of_light();
  if (is_dimmed && !records.has_layers()) skip_dark(camera_samples);
  camera_interiors_.find(camera_samples);
  sample_lights(camera_samples, tracer, records);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (const float weight = camera_samples[i].weight; weight != 1) records.weigh(i, weight);
    if (is_dimmed) records.dim(i, camera_samples[i].light);
  }
}

}  // namespace twinray
