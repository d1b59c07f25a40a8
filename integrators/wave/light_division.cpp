// SPDX-License-Identifier: Apache-2.0
// Where a wave's light belongs, if its parts are asked for: by path (integrators/light_paths.h), and by group
// (integrators/light_groups.h).
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::keep_first_scattering() {
  for (std::size_t i = 0; i < paths_.size; ++i) wave_.first_is_other[paths_.sample[i]] = 0;
  for (const OtherSurface& other : wave_.others) {
    const std::uint32_t sample = paths_.sample[other.index];
    const FirstScattering first =
        first_scattering(other.at, paths_.direction.at(other.index), Seeking(wave_.seeking[other.index]));
    wave_.first_is_other[sample] = 1;
    wave_.first_diffuse.set(sample, first.diffuse);
    wave_.first_transmitted[sample] = first.is_transmitted;
  }
}

void PathWave::gather_scattered_light(float divisor) {
  for (OtherSurface& other : wave_.others) {
    const std::size_t i = other.index;
    const Rgb scattered = connections_.scattered.at<Rgb>(i);
    if (is_black(scattered)) continue;
    const Rgb light = scattered * connections_.arriving.at<Rgb>(i) / light_.pdf[i];
    other.scattered.add(other.at, light_.direction.at(i), light / divisor);
  }
}

void PathWave::add_direct_paths() {
  auto other = wave_.others.begin();
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const std::uint32_t sample = paths_.sample[i];
    const Rgb throughput = paths_.throughput.at<Rgb>(i);
    const Rgb term = context_.options.clamped(throughput * connections_.sum.at<Rgb>(i), depth_ + 1);
    const bool is_other = other != wave_.others.end() && other->index == i;
    if (depth_ > 0)
      add_scattered_light(first_scattering_of(sample), term, depth_ + 1, paths_of(sample));
    else if (is_other && !other->at.is_lambert())
      twinray::add_direct_light(throughput, other->scattered, term, paths_of(sample));
    else
      add_scattered_light({}, term, 1, paths_of(sample));
    if (is_other) ++other;
  }
}

void PathWave::gather_groups(std::uint32_t light, float divisor) {
  for (std::size_t k = 0; k < connections_.size; ++k) {
    const std::size_t i = connections_.surface[k];
    const Rgb brought = connections_.scattered.at<Rgb>(i) * connections_.arriving.at<Rgb>(i) / light_.pdf[i];
    groups_of(i).add(context_.transport.lights.source(light, light_.source[i]), brought / divisor);
  }
}

void PathWave::gather_groups_around(float divisor) {
  for (std::size_t k = 0; k < connections_.size; ++k) {
    const std::size_t i = connections_.surface[k];
    const Ray& ray = connections_.rays[k];
    const Hit& hit = connections_.hits[k];
    const Rgb scattered = connections_.scattered.at<Rgb>(i);
    const Rgb passed = connections_.passed[k];
    const LightGroups groups = groups_of(i);
    for_each_lamp(context_.transport, {hit, ray.direction}, [&](std::uint32_t lamp, const Rgb& radiance) {
      groups.add(lamp, scattered * (radiance * passed) / light_.pdf[i] / divisor);
    });
  }
}

void PathWave::add_direct_groups() {
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Rgb sum = connections_.sum.at<Rgb>(i);
    if (is_black(sum)) continue;  // So are the groups' sums.
    const Rgb throughput = paths_.throughput.at<Rgb>(i);
    const float factor = context_.options.clamp_factor(throughput * sum, depth_ + 1);
    groups_of(i).move_to(records_[Division::groups][paths_.sample[i]], throughput, factor);
  }
}

}  // namespace twinray
