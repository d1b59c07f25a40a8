// SPDX-License-Identifier: Apache-2.0
#include "core/color_matrix.h"

namespace twinray {

ColorMatrix product(const ColorMatrix& a, const ColorMatrix& b) {
  ColorMatrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

ColorMatrix inverse(const ColorMatrix& m) {
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  ColorMatrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = cofactor(j, i) / determinant;
  return result;
}

std::array<double, 3> transformed(const ColorMatrix& m, const std::array<double, 3>& v) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

ColorMatrix to_xyz(const Primaries& primaries) {
  const auto& [r, g, b, w] = primaries;
  const auto column = [](const Chromaticity& c) { return std::array{c.x / c.y, 1.0, (1 - c.x - c.y) / c.y}; };
  ColorMatrix m{};
  const std::array columns{column(r), column(g), column(b)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = columns[j][i];
  const std::array<double, 3> luminances = transformed(inverse(m), column(w));
  for (auto& row : m)
    for (std::size_t j = 0; j < 3; ++j) row[j] *= luminances[j];
  return m;
}

ColorMatrix adapted(const ColorMatrix& to_cones, const std::array<double, 3>& from,
                    const std::array<double, 3>& to) {
  ColorMatrix scaled = to_cones;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& entry : scaled[i]) entry *= to[i] / from[i];
  return scaled;
}

ColorMatrix to_srgb(const Primaries& primaries) {
  constexpr std::array<double, 3> full{1, 1, 1};
  const ColorMatrix theirs = product(bradford, to_xyz(primaries)),
                    ours = product(bradford, to_xyz(srgb_primaries));
  return product(inverse(ours), adapted(theirs, transformed(theirs, full), transformed(ours, full)));
}

}  // namespace twinray
