// SPDX-License-Identifier: Apache-2.0
#include "io/picture/primaries.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

bool are_near(const Chromaticity& a, const Chromaticity& b) {
  constexpr double tolerance = 1e-3;
  return std::fabs(a.x - b.x) <= tolerance && std::fabs(a.y - b.y) <= tolerance;
}

bool is_usable(const ColorMatrix& matrix) {
  constexpr double most = 100;
  return std::all_of(&matrix[0][0], &matrix[0][0] + 9, [](double entry) { return std::fabs(entry) < most; });
}

}  // namespace

void take_as_srgb(const Primaries& primaries, Image& image) {
  const auto& [red, green, blue, white_point] = srgb_primaries;
  if (are_near(primaries.red, red) && are_near(primaries.green, green) && are_near(primaries.blue, blue) &&
      are_near(primaries.white, white_point))
    return;
  const ColorMatrix to_ours = to_srgb(primaries);
  if (!is_usable(to_ours)) return;
  for (Rgb& pixel : image.pixels) {
    if (pixel.r == pixel.g && pixel.g == pixel.b) continue;
    const bool is_positive = pixel.r >= 0 && pixel.g >= 0 && pixel.b >= 0;
    pixel = transformed(to_ours, pixel);
    if (is_positive) pixel = at_least_zero(pixel);
  }
}

}  // namespace twinray
