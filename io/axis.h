// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/vec.h"

namespace twinray {

/// A vector in double: an axis of a camera, or between two points.
struct Axis {
  double x, y, z;

  Axis operator-(const Axis& b) const { return {x - b.x, y - b.y, z - b.z}; }
  double length() const { return std::sqrt(x * x + y * y + z * z); }
  double dot(const Axis& b) const { return x * b.x + y * b.y + z * b.z; }
  Axis cross(const Axis& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
  Axis minus(const Axis& b, double s) const { return {x - s * b.x, y - s * b.y, z - s * b.z}; }
  Axis unit() const { return {x / length(), y / length(), z / length()}; }
  static Axis of(const Vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }
  Vec3 vec() const { return {float(x), float(y), float(z)}; }
};

}  // namespace twinray
