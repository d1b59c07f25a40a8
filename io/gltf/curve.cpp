// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/curve.h"

#include <algorithm>

#include "core/quaternion.h"

namespace twinray {
namespace {

using Value = std::vector<double>;

Value mix(const Value& a, const Value& b, double of_a, double of_b) {
  Value sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = of_a * a[i] + of_b * b[i];
  return sum;
}

Quaternion quaternion(const Value& numbers) { return {numbers[0], numbers[1], numbers[2], numbers[3]}; }

Value numbers_of(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }

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
  if (!is_spline && is_rotation) return numbers_of(slerp(quaternion(value(a)), quaternion(value(b)), t));
  if (!is_spline) return mix(value(a), value(b), 1 - t, t);
  const double t2 = t * t, t3 = t2 * t;
  const Value ends = mix(value(a), value(b), 2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3);
  const Value tangents = mix(part(a, 2), part(b, 0), step * (t3 - 2 * t2 + t), step * (t3 - t2));
  const Value sum = mix(ends, tangents, 1, 1);
  return is_rotation ? numbers_of(unit(quaternion(sum))) : sum;
}

}  // namespace twinray
