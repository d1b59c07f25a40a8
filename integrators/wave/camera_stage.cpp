// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/camera_stage.h"

#include <algorithm>
#include <memory>

namespace twinray {

struct CameraStage::Draws {
  Keys pixel;
  Words index;
  Floats x, y, weight;  ///< Draws of a place in the pixel, then that place, then that in the frame.
  Floats lens_x, lens_y;
  Columns3 directions;
};

CameraStage::Draws& CameraStage::draws_of_this_thread() {
  static thread_local const auto draws = std::make_unique<Draws>();
  return *draws;
}

CameraStage::CameraStage(const Camera& camera, const CameraSampling& sampling, const std::string& simd)
    : camera_(camera),
      sampling_(sampling),
      filter_(sampling.filter),
      pixel_cone_(pixel_cone(camera, sampling.width, sampling.height)),
      stages_(wave_stages_of(simd)) {}

void CameraStage::make(std::span<const PixelSample> samples, std::span<CameraSample> made) const {
  for (std::size_t first = 0; first < samples.size(); first += wave_size) {
    const std::size_t size = std::min(wave_size, samples.size() - first);
    make_together(samples.subspan(first, size), made.subspan(first, size));
  }
}

CameraSample CameraStage::make_alone(const PixelSample& sample) const {
  const VertexSampler sampler(sampling_.kind, PathKey(key_of(sample)), 0);
  const FilterSampler::Place place = sampling_.samples == 1 ? FilterSampler::Place{{0.5f, 0.5f}, 1}
                                                            : filter_.place(sampler.draw_2d(Purpose::pixel));
  return sample_at(sample, place, has_lens(camera_) ? sampler.draw_2d(Purpose::lens) : Vec2{});
}

void CameraStage::draw(std::span<const PixelSample> samples, Draws& draws) const {
  PixelKeys pixel_key;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    draws.pixel.set(i, pixel_key(key_of(samples[i])));
    draws.index[i] = samples[i].index;
  }
  const auto draw_2d = [&](Purpose purpose, Floats& x, Floats& y) {
    stages_->draw(draws.pixel, draws.index, samples.size(), {sampling_.kind, place_of(purpose, 0), {}}, x, y);
  };
  draw_2d(Purpose::pixel, draws.x, draws.y);
  if (has_lens(camera_)) draw_2d(Purpose::lens, draws.lens_x, draws.lens_y);
}

void CameraStage::make_together(std::span<const PixelSample> samples, std::span<CameraSample> made) const {
  if (!stages_ || sampling_.samples == 1) {
    for (std::size_t i = 0; i < samples.size(); ++i) made[i] = make_alone(samples[i]);
    return;
  }
  Draws& draws = draws_of_this_thread();
  draw(samples, draws);
  stages_->place_in_pixels(filter_, samples.size(), draws.x, draws.y, draws.weight);
  if (is_pinhole()) return make_of_pinhole(samples, draws, made);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec2 lens = has_lens(camera_) ? Vec2{draws.lens_x[i], draws.lens_y[i]} : Vec2{};
    made[i] = sample_at(samples[i], {{draws.x[i], draws.y[i]}, draws.weight[i]}, lens);
  }
}

void CameraStage::make_of_pinhole(std::span<const PixelSample> samples, Draws& draws,
                                  std::span<CameraSample> made) const {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    draws.x[i] = float(samples[i].x) + draws.x[i];
    draws.y[i] = float(samples[i].y) + draws.y[i];
  }
  stages_->aim_pinhole({camera_, sampling_.width, sampling_.height}, draws.x, draws.y, samples.size(),
                       draws.directions);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Ray ray{.origin = camera_.position,
                  .direction = draws.directions.at(i),
                  .t_min = camera_.clip_near,
                  .t_max = camera_.clip_far};
    made[i] = sample_of({ray}, samples[i], draws.weight[i]);
  }
}

}  // namespace twinray
