// SPDX-License-Identifier: Apache-2.0
// Axis-aligned bounding boxes. A default box is empty: lower = +infinity, upper = -infinity.
#pragma once
#include <algorithm>
#include <limits>

#include "core/vec.h"

namespace twinray {

struct Aabb {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Vec3 lower{infinity, infinity, infinity};
  Vec3 upper{-infinity, -infinity, -infinity};

  constexpr void extend(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], p[axis]);
      upper[axis] = std::max(upper[axis], p[axis]);
    }
  }
  /// An empty box changes nothing.
  constexpr void extend(const Aabb& b) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], b.lower[axis]);
      upper[axis] = std::max(upper[axis], b.upper[axis]);
    }
  }
  constexpr bool is_empty() const {
    return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z);
  }
  constexpr bool contains(const Aabb& b) const {
    return b.is_empty() || (lower.x <= b.lower.x && lower.y <= b.lower.y && lower.z <= b.lower.z &&
                            upper.x >= b.upper.x && upper.y >= b.upper.y && upper.z >= b.upper.z);
  }
  /// The middle; of an empty box, meaningless.
  constexpr Vec3 center() const { return lower * 0.5f + upper * 0.5f; }
  /// Edge lengths; of an empty box, zero.
  constexpr Vec3 extent() const { return is_empty() ? Vec3{} : upper - lower; }
  /// The area of half of the surface (three faces), in double so that no box overflows; an empty box has 0.
  constexpr double half_area() const {
    const Vec3 e = extent();
    return double(e.x) * double(e.y) + double(e.y) * double(e.z) + double(e.z) * double(e.x);
  }
  friend constexpr bool operator==(const Aabb&, const Aabb&) = default;
};

}  // namespace twinray
