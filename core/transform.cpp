// SPDX-License-Identifier: Apache-2.0
#include "core/transform.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace twinray {
namespace {

/// Row `row` of A times v.
double row_times(const double (&m)[3][4], int row, const Vec3& v) {
  return m[row][0] * v.x + m[row][1] * v.y + m[row][2] * v.z;
}

/// The determinant of A without this row and this column, with its sign.
double cofactor(const double (&m)[3][4], int row, int column) {
  const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
  const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
  return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
}

/// A step of Newton's method towards the inverse of A: X (2 - A X).
void refine_inverse(const double (&a)[3][4], double (&x)[3][4]) {
  double rest[3][3], refined[3][3];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      rest[row][column] = row == column ? 2 : 0;
      for (int k = 0; k < 3; ++k) rest[row][column] -= a[row][k] * x[k][column];
    }
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      refined[row][column] = 0;
      for (int k = 0; k < 3; ++k) refined[row][column] += x[row][k] * rest[k][column];
    }
  for (int row = 0; row < 3; ++row) std::copy_n(refined[row], 3, x[row]);
}

}  // namespace

Transform Transform::operator*(const Transform& other) const {
  Transform product;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      double sum = column == 3 ? m[row][3] : 0;
      for (int k = 0; k < 3; ++k) sum += m[row][k] * other.m[k][column];
      product.m[row][column] = sum;
    }
  return product;
}

Vec3 Transform::point(const Vec3& p) const {
  return {float(row_times(m, 0, p) + m[0][3]), float(row_times(m, 1, p) + m[1][3]),
          float(row_times(m, 2, p) + m[2][3])};
}

Vec3 Transform::vector(const Vec3& v) const {
  return {float(row_times(m, 0, v)), float(row_times(m, 1, v)), float(row_times(m, 2, v))};
}

Vec3 Transform::transposed_vector(const Vec3& v) const {
  const auto column = [&](int k) { return float(m[0][k] * v.x + m[1][k] * v.y + m[2][k] * v.z); };
  return {column(0), column(1), column(2)};
}

// By the cofactors of A, which are those of its inverse's transpose but for the determinant.
Vec3 Transform::front(const Vec3& n) const {
  double moved[3], squared = 0;
  for (int row = 0; row < 3; ++row) {
    moved[row] = cofactor(m, row, 0) * n.x + cofactor(m, row, 1) * n.y + cofactor(m, row, 2) * n.z;
    squared += moved[row] * moved[row];
  }
  if (!(squared > 1e-200 && squared < 1e200)) {
    // A may be of a size whose squares are out of range: then once more with one of a size near 1.
    const double size = stretch();
    const bool has_other_size = size > 0 && std::isfinite(size) && !(size > 0.5 && size < 2);
    return has_other_size ? (scaling(1 / size, 1 / size, 1 / size) * *this).front(n) : Vec3{0, 0, 0};
  }
  const double scale = (determinant() < 0 ? -1 : 1) / std::sqrt(squared);
  return {float(moved[0] * scale), float(moved[1] * scale), float(moved[2] * scale)};
}

double Transform::determinant() const {
  return m[0][0] * cofactor(m, 0, 0) + m[0][1] * cofactor(m, 0, 1) + m[0][2] * cofactor(m, 0, 2);
}

double Transform::stretch() const {
  double most = 0;
  for (const auto& row : m) most = std::max(most, std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
  return most;
}

Transform Transform::inverse() const {
  const double divisor = determinant();
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result.m[row][column] = cofactor(m, column, row) / divisor;
  // Of a needle the determinant has lost as many digits as the square of the condition has.
  for (int step = 0; step < 2; ++step) refine_inverse(m, result.m);
  for (int row = 0; row < 3; ++row) {
    const double* const r = result.m[row];
    result.m[row][3] = -(r[0] * m[0][3] + r[1] * m[1][3] + r[2] * m[2][3]);
  }
  return result;
}

Transform Transform::translation(double x, double y, double z) {
  return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}}};
}

Transform Transform::scaling(double x, double y, double z) {
  return {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}};
}

Transform Transform::rotation(const Vec3& axis, double angle_degrees) {
  const double ax = axis.x, ay = axis.y, az = axis.z;
  const double length = std::sqrt(ax * ax + ay * ay + az * az);
  const double x = ax / length, y = ay / length, z = az / length;
  // Whole turns go first: fmod is exact, and the angle stays within the range of our sine.
  const double angle = std::fmod(angle_degrees, 360.0) * radians_per_degree;
  const double s = sin_radians(angle), c = cos_radians(angle), d = 1 - c;
  return {{{c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0},
           {y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0},
           {z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0}}};
}

}  // namespace twinray
