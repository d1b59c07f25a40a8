// SPDX-License-Identifier: Apache-2.0
#include "core/octahedron.h"

#include <cmath>

namespace twinray {

Vec3 octahedral_decode(float u, float v) {
  double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0;
  const double z = 1.0 - std::fabs(x) - std::fabs(y);
  if (z < 0) {
    const double folded = std::copysign(1.0 - std::fabs(y), x);
    y = std::copysign(1.0 - std::fabs(x), y);
    x = folded;
  }
  const double length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

Vec2 octahedral_encode(double x, double y, double z) {
  const double norm = std::fabs(x) + std::fabs(y) + std::fabs(z);
  double a = x / norm, b = y / norm;
  if (z < 0) {
    const double folded = std::copysign(1.0 - std::fabs(b), a);
    b = std::copysign(1.0 - std::fabs(a), b);
    a = folded;
  }
  return {float(0.5 * a + 0.5), float(0.5 * b + 0.5)};
}

}  // namespace twinray
