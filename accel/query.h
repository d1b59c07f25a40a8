// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "accel/counters.h"
#include "core/ray.h"

namespace twinray {

/// All that one question to an accelerator carries; it lives for the call alone, and travels in registers.
/// Which hits of a shape with holes count is no part of it: the geometry says so (Geometry::accepts), so that
/// it is the same for every question, of one ray or of many.
struct Query {
  const Ray& ray;
  /// Where given, what the query did is added here. The hand-written trees then take their scalar traversal.
  QueryCounts* counts = nullptr;
};

}  // namespace twinray
