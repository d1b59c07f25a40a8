// SPDX-License-Identifier: Apache-2.0
// Where a wave's light belongs, if its parts are asked for (integrators/light_parts.h).
#include "integrators/light_parts.h"

#include "integrators/wave/path_wave.h"

namespace twinray {

FirstScattering PathWave::first_scattering_of(std::uint32_t sample) const {
  return {wave_.first_diffuse.at<Rgb>(sample), wave_.first_transmitted[sample] != 0};
}

void PathWave::keep_first_scattering() {
  const auto keep = [&](std::size_t i, const FirstScattering& first) {
    wave_.first_diffuse.set(paths_.sample[i], first.diffuse);
    wave_.first_transmitted[paths_.sample[i]] = first.is_transmitted;
  };
  for (std::size_t i = 0; i < paths_.size; ++i) keep(i, {});
  for (const OtherSurface& other : wave_.others)
    keep(other.index,
         first_scattering(other.at, paths_.direction.at(other.index), Seeking(wave_.seeking[other.index])));
}

void PathWave::gather_direct_parts(float divisor) {
  for (OtherSurface& other : wave_.others) {
    const std::size_t i = other.index;
    const Rgb scattered = connections_.scattered.at<Rgb>(i);
    if (is_black(scattered)) continue;
    const Rgb light = scattered * connections_.arriving.at<Rgb>(i) / light_.pdf[i];
    other.parts.add(other.at, light_.direction.at(i), light / divisor);
  }
}

void PathWave::add_direct_parts() {
  auto other = wave_.others.begin();
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const std::uint32_t sample = paths_.sample[i];
    const Rgb throughput = paths_.throughput.at<Rgb>(i);
    const Rgb term = context_.options.clamped(throughput * connections_.sum.at<Rgb>(i), depth_ + 1);
    const bool is_other = other != wave_.others.end() && other->index == i;
    if (depth_ > 0)
      add_scattered_light(first_scattering_of(sample), term, depth_ + 1, records_, sample);
    else if (is_other)
      twinray::add_direct_light(other->at, throughput, other->parts, term, records_, sample);
    else
      add_scattered_light({}, term, 1, records_, sample);
    if (is_other) ++other;
  }
}

}  // namespace twinray
