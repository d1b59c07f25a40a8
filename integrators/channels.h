// SPDX-License-Identifier: Apache-2.0
// Private: colors by their channels.
#pragma once
#include <algorithm>

#include "core/rgb.h"

namespace twinray {

/// Red is 0, green 1, blue 2.
inline float channel_of(const Rgb& color, int channel) {
  return channel == 0 ? color.r : channel == 1 ? color.g : color.b;
}

inline float sum_of(const Rgb& color) { return color.r + color.g + color.b; }

struct ChosenChannel {
  int channel;
  float rest;  ///< The part of the draw that is left once it has chosen, as even as the draw: in [0, 1).
};

/// Chooses a channel by its chance; they sum up to 1. u in [0, 1).
inline ChosenChannel choose_channel(const Rgb& chance, float u) {
  int channel = 0;
  while (channel < 2 && u >= channel_of(chance, channel)) u -= channel_of(chance, channel++);
  // A sum that is rounded to below 1 must not let the last channel be chosen where it cannot be.
  while (channel > 0 && channel_of(chance, channel) == 0) --channel;
  return {channel, std::min(u / channel_of(chance, channel), 1 - 0x1p-24f)};
}

}  // namespace twinray
