// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "accel/counters.h"
#include "core/ray.h"

namespace twinray {

/// All that one question to an accelerator carries; it lives for the call alone, and travels in registers. A
/// test of acceptance (alpha cut-out: whether a hit counts, as a pure function of ray and hit) would be a
/// further member here, and the engines would ask it where they keep a hit.
struct Query {
  const Ray& ray;
  /// Where given, what the query did is added here. The hand-written trees then take their scalar traversal.
  QueryCounts* counts = nullptr;
};

}  // namespace twinray
