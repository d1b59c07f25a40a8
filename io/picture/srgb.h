// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/elementary.h"

namespace twinray {

/// The linear value of a number in [0, 1] that sRGB (IEC 61966-2-1) encodes.
inline float decode_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : float(pow_of((double(encoded) + 0.055) / 1.055, 2.4));
}

}  // namespace twinray
