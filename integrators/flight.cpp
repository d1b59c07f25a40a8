// SPDX-License-Identifier: Apache-2.0
#include "integrators/flight.h"

#include <algorithm>
#include <limits>

#include "core/elementary.h"
#include "core/interiors.h"
#include "integrators/channels.h"

namespace twinray {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

Flight::Flight(const Rgb& throughput, float u) : chance_(throughput / sum_of(throughput)) {
  const auto [channel, rest] = choose_channel(chance_, u);
  channel_ = channel;
  depth_ = -log_of(1 - rest);
}

float Flight::reach(const Interior& medium) const {
  const float own = channel_of(medium.extinction(), channel_);
  return own >= least_extinction ? depth_ / own : infinity;
}

bool Flight::ends_within(const Interior& medium, const MediumColumn& column) {
  has_begun_ = true;
  const Rgb extinction = medium.extinction();
  const float own = channel_of(extinction, channel_);
  const auto [distance, passed] = column.reach(reach(medium));
  distance_ = distance;
  has_ended_ = distance_ < infinity;
  if (has_ended_)
    medium_ = medium;
  else if (own >= least_extinction)
    depth_ = std::max(depth_ - own * passed, 0.0f);
  left_ = left_ * transmittance(extinction, passed);
  return has_ended_;
}

Rgb Flight::weight() const {
  if (!has_begun_) return {1, 1, 1};
  if (!has_ended_) return left_ / sum_of(chance_ * left_);
  return medium_.scattering * left_ / sum_of(chance_ * medium_.extinction() * left_);
}

}  // namespace twinray
