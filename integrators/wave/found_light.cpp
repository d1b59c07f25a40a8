// SPDX-License-Identifier: Apache-2.0
// The light that a wave's rays find by themselves: of emitters that they hit, and of what is beyond the
// scene.
#include <span>

#include "integrators/direct_light.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::add_emission() {
  const LightSet& lights = context_.transport.lights;
  const Geometry& geometry = *context_.transport.scene.geometry;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    if (!hit.is_miss() && !context_.shapes[hit.mesh].emits) continue;
    const Vec3 direction = normalize(paths_.direction.at(i));
    const Rgb throughput = paths_.throughput.at<Rgb>(i);
    const Rgb light = throughput * (hit.is_miss() ? lights.background(direction)
                                                  : lights.emitted(surface_at(geometry, hit), -direction));
    radiance_[i] += light;
    if (has_light_paths_) add_seen_light(hit.is_miss(), light, paths_of(std::uint32_t(i)));
    if (!has_light_groups_) continue;
    add_seen_groups(context_.transport, {hit, direction}, groups_of(i));
    groups_of(i).move_to(records_[Division::groups][i], throughput);
  }
}

void PathWave::add_found_light() {
  if (context_.transport.method != DirectMethod::mis && wave_.others.empty()) return;
  std::uint32_t escaped[views_together];
  std::size_t count = 0;
  for (std::size_t k = 0; k < paths_.size; ++k) {
    const Hit& hit = wave_.hits[k];
    if (!hit.is_miss() && !context_.shapes[hit.mesh].emits) continue;
    const bool is_looking = context_.transport.method == DirectMethod::mis ||
                            Seeking(wave_.seeking[wave_.kept[k]]) == Seeking::alone;
    if (!hit.is_miss() || !is_looking) {
      add_found(k, {hit, normalize(paths_.direction.at(k))});
      continue;
    }
    escaped[count++] = std::uint32_t(k);
    if (count < views_together) continue;
    add_found_beyond(escaped);
    count = 0;
  }
  add_found_beyond(std::span(escaped).first(count));
}

void PathWave::add_found_beyond(std::span<const std::uint32_t> escaped) {
  const LightSet& lights = context_.transport.lights;
  const std::size_t lamps = lights.distant().size();
  Vec3 directions[views_together];
  for (std::size_t i = 0; i < escaped.size(); ++i) directions[i] = normalize(paths_.direction.at(escaped[i]));
  lights.view(std::span(directions).first(escaped.size()), wave_.views);
  for (std::size_t i = 0; i < escaped.size(); ++i)
    add_found(escaped[i],
              {wave_.hits[escaped[i]], directions[i], std::span(wave_.views).subspan(i * lamps, lamps)});
}

void PathWave::add_found(std::size_t k, const Arrival& arrival) {
  const LightGroups groups = has_light_groups_ ? groups_of(k) : LightGroups{};
  const Rgb throughput = paths_.throughput.at<Rgb>(k);
  const Rgb light = throughput * found_light(context_.transport, departure_from(wave_.kept[k]), arrival,
                                             tracer_.observer(), groups);
  const float factor = context_.options.clamp_factor(light, depth_);
  const std::uint32_t sample = paths_.sample[k];
  radiance_[sample] += light * factor;
  if (has_light_paths_)
    add_scattered_light(first_scattering_of(sample), light * factor, depth_, paths_of(sample));
  if (has_light_groups_) groups.move_to(records_[Division::groups][sample], throughput, factor);
}

}  // namespace twinray
