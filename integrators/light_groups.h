// SPDX-License-Identifier: Apache-2.0
// The light of a picture by the groups of lights that it came from.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/scene.h"

namespace twinray {

/// What lights bring to one vertex of a path, group by group; without sums, nothing is kept.
class LightGroups {
 public:
  LightGroups() = default;
  /// One sum for each of the scene's groups, all black; or none.
  LightGroups(const Scene& scene, std::span<Rgb> sums)
      : lights_(scene.lights), media_group_(scene.media_group), sums_(sums) {}

  bool are_kept() const { return !sums_.empty(); }
  /// Adds what a light brings.
  void add(std::uint32_t light, const Rgb& radiance) const {
    if (are_kept()) sums_[lights_[light].group] += radiance;
  }
  /// Adds what media emit.
  void add_glow(const Rgb& radiance) const {
    if (are_kept()) sums_[media_group_] += radiance;
  }
  /// Adds the sums, times `throughput` and `factor`, to the parts of a sample's radiance; they are black
  /// then.
  void move_to(std::span<Rgb> parts, const Rgb& throughput, float factor = 1) const {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (!is_black(sums_[i])) parts[i] += throughput * sums_[i] * factor;
    std::fill(sums_.begin(), sums_.end(), Rgb{});
  }

 private:
  std::span<const Light> lights_;
  std::uint32_t media_group_ = no_light;
  std::span<Rgb> sums_;
};

}  // namespace twinray
