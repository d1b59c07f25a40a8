// SPDX-License-Identifier: Apache-2.0
// What absorbs light, and how much of it.
#pragma once
#include <cmath>

#include "core/rgb.h"

namespace twinray::test {

/// By each unit of length.
inline constexpr Rgb absorption{0.5f, 1, 2};

/// The luminance of white light that has gone so far through it.
inline double left_of(double length) {
  const auto channel = [&](float a) { return std::exp(-double(a) * length); };
  return 0.2126 * channel(absorption.r) + 0.7152 * channel(absorption.g) + 0.0722 * channel(absorption.b);
}

}  // namespace twinray::test
