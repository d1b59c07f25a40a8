// SPDX-License-Identifier: Apache-2.0
// What a wave writes of its paths' surfaces into their records.
#include "integrators/layer_records.h"
#include "integrators/wave/path_wave.h"

namespace twinray {

void PathWave::record_coverage() {
  if (!records_.has(Layer::alpha)) return;
  for (std::size_t i = 0; i < paths_.size; ++i)
    record_alpha(wave_.hits[i], context_.has_environment, records_, paths_.sample[i]);
}

void PathWave::record_surfaces() {
  if (shows_features(records_) && (depth_ == 0 || is_following_)) record_features();
  if (depth_ > 0 || !shows_first_surface(records_)) return;
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const Vec3 normal = surfaces_.point.normal.at(i) * surfaces_.facing[i];
    record_first_surface(context_.transport.scene, {wave_.hits[i], surfaces_.point.position.at(i), normal},
                         records_, paths_.sample[i]);
  }
}

void PathWave::record_features() {
  for (std::size_t i = 0; i < paths_.size; ++i) {
    const std::uint32_t sample = paths_.sample[i];
    if (depth_ == 0 || wave_.follows[sample])
      twinray::record_features({paths_.throughput.at<Rgb>(i), paths_.eta_squared[i],
                                surfaces_.reflectance.at<Rgb>(i), surfaces_.shading.at(i)},
                               records_, sample);
  }
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
