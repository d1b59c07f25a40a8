// SPDX-License-Identifier: Apache-2.0
#include "integrators/flight.h"

#include <algorithm>
#include <limits>

#include "core/elementary.h"
#include "core/interiors.h"

namespace twinray {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float channel_of(const Rgb& color, int channel) {
  return channel == 0 ? color.r : channel == 1 ? color.g : color.b;
}

float sum_of(const Rgb& color) { return color.r + color.g + color.b; }

}  // namespace

Flight::Flight(const Rgb& throughput, float u) : chance_(throughput / sum_of(throughput)) {
  // The part of the draw that is left once it has chosen is as even as the draw.
  while (channel_ < 2 && u >= channel_of(chance_, channel_)) u -= channel_of(chance_, channel_++);
  // A sum that is rounded to below 1 must not let the last channel be chosen where it cannot be.
  while (channel_of(chance_, channel_) == 0) --channel_;
  const float rest = std::min(u / channel_of(chance_, channel_), 1 - 0x1p-24f);
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
  const float amount = reach(medium);
  distance_ = column.reach(amount);
  has_ended_ = distance_ < infinity;
  const float passed = has_ended_ ? amount : column.amount();
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
