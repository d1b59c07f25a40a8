// SPDX-License-Identifier: Apache-2.0
// What a wave writes of its paths' surfaces into their records.
#include <span>

#include "integrators/layer_records.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::record_coverage() {
  const std::span<Rgb> alpha = records_[Layer::alpha];
  if (alpha.empty()) return;
  for (std::size_t i = 0; i < paths_.size; ++i)
    alpha[paths_.sample[i]] = alpha_record(wave_.hits[i].is_miss(), context_.has_environment);
}

void PathWave::record_surfaces() {
  if (depth_ == 0 || is_following_) record_features();
  if (depth_ > 0) return;
  record_first_surface(context_.transport.scene, [&](Layer layer, auto&& value) {
    const std::span<Rgb> column = records_[layer];
    if (column.empty()) return;
    for (std::size_t i = 0; i < paths_.size; ++i) {
      if (is_in_medium(i)) continue;
      const Vec3 normal = surfaces_.point.normal.at(i) * surfaces_.facing[i];
      column[paths_.sample[i]] = value({wave_.hits[i], surfaces_.point.position.at(i), normal});
    }
  });
}

void PathWave::record_features() {
  const auto record = [&](Layer layer, auto&& value) {
    const std::span<Rgb> column = records_[layer];
    if (column.empty()) return;
    for (std::size_t i = 0; i < paths_.size; ++i)
      if (const std::uint32_t sample = paths_.sample[i]; depth_ == 0 || wave_.follows[sample])
        column[sample] = value(i);
  };
  record(Layer::albedo, [&](std::size_t i) {
    return albedo_record(
        {paths_.throughput.at<Rgb>(i), paths_.eta_squared[i], surfaces_.reflectance.at<Rgb>(i)});
  });
  record(Layer::normal, [&](std::size_t i) {
    return vector_record(is_in_medium(i) ? surfaces_.point.normal.at(i) : surfaces_.shading.at(i));
  });
}

void PathWave::follow_mirrors() {
  is_following_ = (depth_ == 0 || is_following_) && !wave_.others.empty();
  if (!is_following_) return;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    std::uint32_t& follows = wave_.follows[paths_.sample[i]];
    follows = (depth_ == 0 || follows) && Seeking(wave_.seeking[i]) == Seeking::alone;
  }
}

}  // namespace twinray
