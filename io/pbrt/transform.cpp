// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/transform.h"

#include <cmath>

#include "io/axis.h"

namespace twinray {
namespace {

Axis column(const Transform& t, int c) { return {t.m[0][c], t.m[1][c], t.m[2][c]}; }

}  // namespace

std::optional<Transform> affine(const std::array<double, 16>& numbers) {
  constexpr double tolerance = 1e-9;
  const double w = numbers[15];
  if (!(std::fabs(w) > tolerance)) return std::nullopt;
  Transform t;
  for (std::size_t column = 0; column < 4; ++column) {
    if (column < 3 && std::fabs(numbers[4 * column + 3]) > tolerance * std::fabs(w)) return std::nullopt;
    for (std::size_t row = 0; row < 3; ++row) t.m[row][column] = numbers[4 * column + row] / w;
  }
  return t;
}

std::optional<Transform> look_at(const std::array<double, 16>& n) {
  const Axis eye{n[0], n[1], n[2]}, target{n[3], n[4], n[5]}, up{n[6], n[7], n[8]};
  const Axis view = (target - eye).unit();
  const Axis right = up.unit().cross(view).unit();
  const Axis above = view.cross(right);
  if (!std::isfinite(right.x + right.y + right.z)) return std::nullopt;
  const Transform to_world{{{right.x, above.x, view.x, eye.x},
                            {right.y, above.y, view.y, eye.y},
                            {right.z, above.z, view.z, eye.z}}};
  return inverse(to_world);
}

std::optional<Transform> inverse(const Transform& t) {
  const Axis x = column(t, 0), y = column(t, 1), z = column(t, 2), origin = column(t, 3);
  const Axis rows[3] = {y.cross(z), z.cross(x), x.cross(y)};
  const double determinant = x.dot(rows[0]);
  if (!std::isfinite(1 / determinant)) return std::nullopt;
  Transform result;
  for (int i = 0; i < 3; ++i) {
    const Axis row{rows[i].x / determinant, rows[i].y / determinant, rows[i].z / determinant};
    result.m[i][0] = row.x, result.m[i][1] = row.y, result.m[i][2] = row.z;
    result.m[i][3] = -row.dot(origin);
  }
  return result;
}

double similarity_scale(const Transform& t) {
  constexpr double tolerance = 1e-5;
  const Axis x = column(t, 0), y = column(t, 1), z = column(t, 2);
  const double square = x.dot(x);
  const auto differs = [&](double value, double wanted) {
    return !(std::fabs(value - wanted) <= tolerance * square);
  };
  if (!(square > 0) || differs(y.dot(y), square) || differs(z.dot(z), square)) return 0;
  if (differs(x.dot(y), 0) || differs(y.dot(z), 0) || differs(z.dot(x), 0)) return 0;
  return std::sqrt(square);
}

double axis_length(const Transform& t, int c) { return column(t, c).length(); }

}  // namespace twinray
