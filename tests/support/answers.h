// SPDX-License-Identifier: Apache-2.0
// Rays and answers that tests of the judge and the oracle make up.
#pragma once
#include "check/oracle.h"

namespace twinray::test {

/// From (x, y, 2) straight down.
inline Ray downward(float x, float y) { return {.origin = {x, y, 2}, .direction = {0, 0, -1}}; }

inline Answer hit(float t, float u, float v, std::uint32_t primitive = 0) {
  return {{t, u, v, primitive}, true};
}
inline const Answer miss;

}  // namespace twinray::test
