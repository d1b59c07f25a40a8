// SPDX-License-Identifier: Apache-2.0
// Private: boxes in four lanes, for the loops in which a builder spends its time.
#pragma once
#include <cstddef>
#include <cstring>

#include "core/aabb.h"
#include "core/lanes.h"

namespace twinray {

/// A box whose corners are the first three lanes of two vectors; what the last lanes hold has no meaning.
struct BoxLanes {
  Float4 lower = splat(Aabb::infinity), upper = splat(-Aabb::infinity);

  BoxLanes() = default;
  BoxLanes(Float4 lower_corner, Float4 upper_corner) : lower(lower_corner), upper(upper_corner) {}
  /// The box at the start of a struct that goes on behind it. What goes on gets into a last lane; products of
  /// denormal numbers are slow, so nothing below multiplies it.
  template <typename T>
  static BoxLanes of(const T& holder) {
    static_assert(sizeof(T) >= 28 && offsetof(T, box) == 0, "28 bytes are read");
    BoxLanes lanes;
    std::memcpy(&lanes.lower, reinterpret_cast<const char*>(&holder), sizeof lanes.lower);
    std::memcpy(&lanes.upper, reinterpret_cast<const char*>(&holder) + 12, sizeof lanes.upper);
    return lanes;
  }

  void extend(const BoxLanes& other) {
    lower = min(lower, other.lower);
    upper = max(upper, other.upper);
  }
  BoxLanes joined(const BoxLanes& other) const { return {min(lower, other.lower), max(upper, other.upper)}; }
  /// The bits of Aabb::center().
  Float4 center() const { return lower * 0.5f + __builtin_shufflevector(upper, upper, 0, 1, 2, 2) * 0.5f; }
  Aabb aabb() const { return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}}; }
  /// The sum of three faces' areas; of an empty box, meaningless.
  float half_area() const {
    const Float4 extent = upper - lower;
    const Float4 products = __builtin_shufflevector(extent, extent, 0, 1, 2, 2) *
                            __builtin_shufflevector(extent, extent, 1, 2, 0, 0);
    return products[0] + products[1] + products[2];
  }
};

}  // namespace twinray
