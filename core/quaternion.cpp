// SPDX-License-Identifier: Apache-2.0
#include "core/quaternion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/elementary.h"

namespace twinray {
namespace {

constexpr double radians_per_turn = 6.283185307179586;

double dot(const Quaternion& a, const Quaternion& b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }

Quaternion sum_of(const Quaternion& a, const Quaternion& b, double of_a, double of_b) {
  return {of_a * a.x + of_b * b.x, of_a * a.y + of_b * b.y, of_a * a.z + of_b * b.z, of_a * a.w + of_b * b.w};
}

Transform sum_of(const Transform& a, const Transform& b, double of_a, double of_b) {
  Transform sum;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      sum.m[row][column] = of_a * a.m[row][column] + of_b * b.m[row][column];
  return sum;
}

Transform without_translation(Transform t) {
  for (auto& row : t.m) row[3] = 0;
  return t;
}

Transform transposed(const Transform& t) {
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result.m[row][column] = t.m[column][row];
  return result;
}

double largest_number(const Transform& t) {
  double largest = 0;
  for (const auto& row : t.m)
    for (const double number : row) largest = std::max(largest, std::fabs(number));
  return largest;
}

/// A matrix as what stretches, and a rotation after that. The stretch of one that mirrors does so along all
/// axes.
struct PolarParts {
  Quaternion rotation;
  Transform stretch;
};

/// Newton's iteration for the orthogonal factor (Higham, "Computing the Polar Decomposition", 1986). Nothing
/// for a matrix that flattens.
std::optional<PolarParts> polar_parts(const Transform& matrix) {
  const Transform linear = without_translation(matrix);
  const double size = largest_number(linear), sign = linear.determinant() < 0 ? -1 : 1;
  if (!(size > 0) || !std::isfinite(size)) return {};
  Transform rotation = sum_of(linear, {}, sign / size, 0);
  constexpr int most_steps = 60;
  constexpr double small_step = 1e-14;
  for (int step = 0; step < most_steps; ++step) {
    if (!(rotation.determinant() > 0)) return {};
    const Transform next = sum_of(rotation, transposed(rotation.inverse()), 0.5, 0.5);
    const double change = largest_number(sum_of(next, rotation, 1, -1));
    rotation = without_translation(next);
    if (change < small_step) break;
  }
  return PolarParts{quaternion_of(rotation), transposed(rotation) * linear};
}

}  // namespace

Quaternion unit(const Quaternion& q) {
  const double length = std::sqrt(dot(q, q));
  return length > 0 && std::isfinite(length) ? sum_of(q, q, 1 / length, 0) : q;
}

Quaternion slerp(const Quaternion& from, const Quaternion& to, double t) {
  const Quaternion a = unit(from);
  Quaternion b = unit(to);
  double cosine = dot(a, b);
  if (cosine < 0) {
    b = sum_of(b, b, -1, 0);
    cosine = -cosine;
  }
  constexpr double nearly_one = 1 - 1e-9;
  if (!(cosine < nearly_one)) return unit(sum_of(a, b, 1 - t, t));
  const double sine = std::sqrt(1 - cosine * cosine);
  const double angle = radians_per_turn * atan2_turns(sine, cosine);
  return sum_of(a, b, sin_radians((1 - t) * angle) / sine, sin_radians(t * angle) / sine);
}

Transform rotation_of(const Quaternion& q) {
  const double length = std::sqrt(dot(q, q));
  if (!(length > 0) || !std::isfinite(length)) return {};
  const double x = q.x / length, y = q.y / length, z = q.z / length, w = q.w / length;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0}}};
}

/// The largest of its four numbers comes from a root, the others from quotients by it.
Quaternion quaternion_of(const Transform& rotation) {
  const auto& m = rotation.m;
  const double trace = m[0][0] + m[1][1] + m[2][2];
  const double squares[] = {1 + 2 * m[0][0] - trace, 1 + 2 * m[1][1] - trace, 1 + 2 * m[2][2] - trace,
                            1 + trace};  // Four times that of x, y, z and w.
  const auto largest = std::max_element(std::begin(squares), std::end(squares)) - std::begin(squares);
  const double xw = m[2][1] - m[1][2], yw = m[0][2] - m[2][0], zw = m[1][0] - m[0][1];
  const double xy = m[1][0] + m[0][1], xz = m[0][2] + m[2][0], yz = m[2][1] + m[1][2];
  const Quaternion multiples[] = {
      {squares[0], xy, xz, xw}, {xy, squares[1], yz, yw}, {xz, yz, squares[2], zw}, {xw, yw, zw, squares[3]}};
  return unit(multiples[largest]);
}

Transform interpolated(const Transform& from, const Transform& to, double t) {
  const auto a = polar_parts(from), b = polar_parts(to);
  const Transform between = sum_of(from, to, 1 - t, t);
  if (!a || !b) return between;
  Transform result =
      rotation_of(slerp(a->rotation, b->rotation, t)) * sum_of(a->stretch, b->stretch, 1 - t, t);
  for (int row = 0; row < 3; ++row) result.m[row][3] = between.m[row][3];
  return result;
}

}  // namespace twinray
