// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/vec.h"
#include "tests/support/catch.h"

namespace twinray::test {

/// Checks that no component differs by more than `within`.
inline void check_near(const Vec3& a, const Vec3& b, float within = 1e-6f) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(max_abs(a - b) <= within);
}

}  // namespace twinray::test
