// SPDX-License-Identifier: Apache-2.0
// The light that a wave's rays find by themselves: of emitters that they hit, and of what is beyond the
// scene.
#include <span>

#include "integrators/direct_light.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

namespace {

/// Paths that have left the scene, of which f gets several at a time.
template <typename F>
class Escaped {
 public:
  explicit Escaped(const F& f) : f_(f) {}
  void add(std::size_t path) {
    paths_[count_++] = std::uint32_t(path);
    if (count_ == Environment::together) finish();
  }
  /// Those that are left.
  void finish() {
    f_(std::span<const std::uint32_t>(paths_).first(count_));
    count_ = 0;
  }

 private:
  F f_;
  std::uint32_t paths_[Environment::together];
  std::size_t count_ = 0;
};

}  // namespace

void PathWave::add_emission() {
  const LightSet& lights = context_.transport.lights;
  const Geometry& geometry = *context_.transport.scene.geometry;
  Escaped escaped([&](std::span<const std::uint32_t> paths) { add_background(paths); });
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Hit& hit = wave_.hits[i];
    if (hit.is_miss()) {
      escaped.add(i);
    } else if (context_.shapes[hit.mesh].emits) {
      const Vec3 direction = normalize(paths_.direction.at(i));
      add_seen(i, direction, lights.emitted(surface_at(geometry, hit), -direction));
    }
  }
  escaped.finish();
}

void PathWave::add_background(std::span<const std::uint32_t> escaped) {
  Vec3 directions[views_together];
  Rgb radiances[views_together];
  for (std::size_t k = 0; k < escaped.size(); ++k) directions[k] = normalize(paths_.direction.at(escaped[k]));
  context_.transport.lights.background(std::span(directions).first(escaped.size()), radiances);
  for (std::size_t k = 0; k < escaped.size(); ++k) add_seen(escaped[k], directions[k], radiances[k]);
}

void PathWave::add_seen(std::size_t i, const Vec3& direction, const Rgb& radiance) {
  const Hit& hit = wave_.hits[i];
  const Rgb throughput = paths_.throughput.at<Rgb>(i), light = throughput * radiance;
  radiance_[i] += light;
  if (has_light_paths_) add_seen_light(hit.is_miss(), light, paths_of(std::uint32_t(i)));
  if (!has_light_groups_) return;
  add_seen_groups(context_.transport, {hit, direction}, groups_of(i));
  groups_of(i).move_to(records_[Division::groups][i], throughput);
}

void PathWave::add_glow(std::size_t i, const Rgb& radiance, int depth) {
  if (!context_.options.counts(depth)) return;
  const float factor = context_.options.clamp_factor(radiance, depth);
  const Rgb light = radiance * factor;
  const std::uint32_t sample = paths_.sample[i];
  radiance_[sample] += light;
  if (has_light_groups_) {
    groups_of(i).add_glow(radiance);
    groups_of(i).move_to(records_[Division::groups][sample], {1, 1, 1}, factor);
  }
  if (!has_light_paths_) return;
  if (depth == 0)
    add_seen_light(false, light, paths_of(sample));
  else
    add_scattered_light(first_scattering_of(sample), light, depth, paths_of(sample));
}

void PathWave::add_found_light() {
  if (context_.transport.method != DirectMethod::mis && wave_.others.empty()) return;
  Escaped escaped([&](std::span<const std::uint32_t> paths) { add_found_beyond(paths); });
  for (std::size_t k = 0; k < paths_.size; ++k) {
    const Hit& hit = wave_.hits[k];
    if (!hit.is_miss() && !context_.shapes[hit.mesh].emits) continue;
    const bool is_looking = context_.transport.method == DirectMethod::mis ||
                            Seeking(wave_.seeking[wave_.kept[k]]) == Seeking::alone;
    if (hit.is_miss() && is_looking)
      escaped.add(k);
    else
      add_found(k, {hit, normalize(paths_.direction.at(k))});
  }
  escaped.finish();
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
