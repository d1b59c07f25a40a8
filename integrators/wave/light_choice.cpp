// SPDX-License-Identifier: Apache-2.0
// How a wave samples a group of lights: each surface one of them, which lanes choose; its sample is made in
// lanes where they know the light, else alone.
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::sample_group(std::uint32_t group) {
  const LightSet& lights = context_.transport.lights;
  LightPicks& picks = wave_.picks;
  for (std::size_t i = 0; i < paths_.size; ++i)
    picks.finer[i] = LightSet::finer_bits({light_.ux[i], light_.uy[i]});
  stages_.choose_lights(lights.group(group), surfaces_, light_.ux, paths_.size, picks);
  stages_.sample_lamps(context_.lamps, picks, surfaces_, light_, paths_.size);
  for (std::size_t i = 0; i < paths_.size; ++i) {
    light_.source[i] = picks.light[i];
    if (picks.probability[i] == 0 || context_.lamps[picks.light[i]].share > 0) continue;
    keep_light_sample(i, lights.sample_chosen(picks.light[i], picks.probability[i], point_at(i),
                                              receiver_at(i), {light_.ux[i], light_.uy[i]}));
  }
}

void PathWave::keep_light_sample(std::size_t i, const LightSample& sample) {
  light_.direction.set(i, sample.direction);
  light_.radiance.set(i, sample.radiance);
  light_.pdf[i] = sample.pdf;
  light_.origin.set(i, sample.shadow_ray.origin);
  light_.towards.set(i, sample.shadow_ray.direction);
  light_.t_max[i] = sample.shadow_ray.t_max;
  light_.source[i] = sample.light;
}

}  // namespace twinray
