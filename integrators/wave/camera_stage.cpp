// SPDX-License-Identifier: Apache-2.0
#include "integrators/wave/camera_stage.h"

#include <algorithm>
#include <memory>

#include "core/lens.h"

namespace twinray {

struct CameraStage::Draws {
  Keys pixel;
  Words index;
  Floats pixel_x, pixel_y, lens_x, lens_y;
};

CameraStage::Draws& CameraStage::draws_of_this_thread() {
  static thread_local const auto draws = std::make_unique<Draws>();
  return *draws;
}

CameraStage::CameraStage(const Camera& camera, const CameraSampling& sampling, const std::string& simd)
    : camera_(camera),
      sampling_(sampling),
      filter_(sampling.filter),
      cone_(camera_cone(camera, sampling.width, sampling.height, sampling.samples)),
      stages_(wave_stages_of(simd)) {}

void CameraStage::make(std::span<const PixelSample> samples, std::span<CameraSample> made) const {
  for (std::size_t first = 0; first < samples.size(); first += wave_size) {
    const std::size_t size = std::min(wave_size, samples.size() - first);
    make_together(samples.subspan(first, size), made.subspan(first, size));
  }
}

CameraSample CameraStage::sample_at(const PixelSample& sample, const FilterSampler::Place& place,
                                    Vec2 lens) const {
  const Ray ray = camera_ray(camera_, frame_point(sample, place.in_pixel), lens);
  return {ray, key_of(sample), cone_, ray.t_max < ray.t_min ? 0 : place.weight};
}

CameraSample CameraStage::make_alone(const PixelSample& sample) const {
  const VertexSampler sampler(sampling_.kind, PathKey(key_of(sample)), 0);
  const FilterSampler::Place place = sampling_.samples == 1 ? FilterSampler::Place{{0.5f, 0.5f}, 1}
                                                            : filter_.place(sampler.draw_2d(Purpose::pixel));
  const Vec2 lens = camera_.lens_radius == 0 ? Vec2{} : lens_point(camera_, sampler.draw_2d(Purpose::lens));
  return sample_at(sample, place, lens);
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
  draw_2d(Purpose::pixel, draws.pixel_x, draws.pixel_y);
  if (camera_.lens_radius != 0) draw_2d(Purpose::lens, draws.lens_x, draws.lens_y);
}

void CameraStage::make_together(std::span<const PixelSample> samples, std::span<CameraSample> made) const {
  if (!stages_ || sampling_.samples == 1) {
    for (std::size_t i = 0; i < samples.size(); ++i) made[i] = make_alone(samples[i]);
    return;
  }
  Draws& draws = draws_of_this_thread();
  draw(samples, draws);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec2 lens =
        camera_.lens_radius == 0 ? Vec2{} : lens_point(camera_, {draws.lens_x[i], draws.lens_y[i]});
    made[i] = sample_at(samples[i], filter_.place({draws.pixel_x[i], draws.pixel_y[i]}), lens);
  }
}

}  // namespace twinray
