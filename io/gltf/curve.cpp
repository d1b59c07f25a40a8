// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/curve.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

using Value = std::vector<double>;

constexpr double radians_per_turn = 6.283185307179586;

Value mix(const Value& a, const Value& b, double of_a, double of_b) {
  Value sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = of_a * a[i] + of_b * b[i];
  return sum;
}

double dot(const Value& a, const Value& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Value unit(const Value& q) {
  const double length = std::sqrt(dot(q, q));
  return length > 0 && std::isfinite(length) ? mix(q, q, 1 / length, 0) : q;
}

/// Shoemake, "Animating Rotation with Quaternion Curves", 1985; the shorter of the two ways.
Value slerp(const Value& from, const Value& to, double t) {
  const Value a = unit(from);
  Value b = unit(to);
  double cosine = dot(a, b);
  if (cosine < 0) {
    b = mix(b, b, -1, 0);
    cosine = -cosine;
  }
  constexpr double nearly_one = 1 - 1e-9;
  if (!(cosine < nearly_one)) return unit(mix(a, b, 1 - t, t));
  const double sine = std::sqrt(1 - cosine * cosine);
  const double angle = radians_per_turn * atan2_turns(sine, cosine);
  return mix(a, b, sin_radians((1 - t) * angle) / sine, sin_radians(t * angle) / sine);
}

}  // namespace

std::vector<double> GltfCurve::at(double seconds) const {
  const bool is_spline = interpolation == "CUBICSPLINE";
  const auto part = [&](std::size_t key, std::size_t which) {
    const std::size_t row = is_spline ? 3 * key + which : key;
    return Value(values.begin() + std::ptrdiff_t(row * numbers),
                 values.begin() + std::ptrdiff_t((row + 1) * numbers));
  };
  const auto value = [&](std::size_t key) { return part(key, 1); };
  const auto next =
      std::upper_bound(times.begin(), times.end(), seconds, [](double a, float b) { return a < double(b); });
  if (next == times.begin()) return value(0);
  const std::size_t b = std::size_t(next - times.begin()), a = b - 1;
  if (next == times.end() || interpolation == "STEP") return value(a);
  const double step = double(times[b]) - double(times[a]), t = (seconds - double(times[a])) / step;
  if (!is_spline) return is_rotation ? slerp(value(a), value(b), t) : mix(value(a), value(b), 1 - t, t);
  const double t2 = t * t, t3 = t2 * t;
  const Value ends = mix(value(a), value(b), 2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3);
  const Value tangents = mix(part(a, 2), part(b, 0), step * (t3 - 2 * t2 + t), step * (t3 - t2));
  const Value sum = mix(ends, tangents, 1, 1);
  return is_rotation ? unit(sum) : sum;
}

}  // namespace twinray
