// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/vec.h"

namespace twinray {

/// The cross product of two edges of a triangle, in double, where that of a small triangle does not
/// underflow.
struct AreaVector {
  double x, y, z;

  /// Of the triangle a, b, c: out of its front.
  AreaVector(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double ux = double(b.x) - a.x, uy = double(b.y) - a.y, uz = double(b.z) - a.z;
    const double vx = double(c.x) - a.x, vy = double(c.y) - a.y, vz = double(c.z) - a.z;
    x = uy * vz - uz * vy;
    y = uz * vx - ux * vz;
    z = ux * vy - uy * vx;
  }
  bool is_zero() const { return x == 0 && y == 0 && z == 0; }
  /// Twice the triangle's area.
  double length() const { return std::sqrt(x * x + y * y + z * z); }
  /// The triangle's area.
  double area() const { return length() / 2; }
  /// The unit normal out of the triangle's front; of one without area, NaNs.
  Vec3 normal() const {
    const double scale = 1 / length();
    return {float(x * scale), float(y * scale), float(z * scale)};
  }
};

}  // namespace twinray
