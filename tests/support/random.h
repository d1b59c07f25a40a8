// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/random.h"

namespace twinray::test {

using twinray::Random;

/// A point of the unit square [0, 1)^2; each component from a draw of its own.
inline Vec2 in_square(Random& random) {
  const float x = random.unit();
  const float y = random.unit();
  return {x, y};
}

}  // namespace twinray::test
