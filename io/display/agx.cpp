// SPDX-License-Identifier: Apache-2.0
#include "io/display/agx.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

constexpr double middle_grey = 0.18, stops_below = 10, stops_above = 6.5;
constexpr double pivot = stops_below / (stops_below + stops_above);  ///< Of the logarithm: middle grey.
constexpr double pivot_value = 0.5, slope = 2, toe_power = 3, shoulder_power = 3.25;
constexpr double display_gamma = 2.2;
/// The primaries are moved away from the white by 1 / (1 - inset).
constexpr double inset = 0.2;
constexpr std::size_t steps = 4096;

/// How far a branch of the curve reaches, so that it ends at 0 or 1 a distance of `width` from the pivot.
double reach(double width, double height, double power) {
  return pow_of(pow_of(slope * width, -power) * (pow_of(slope * width / height, power) - 1), -1 / power);
}

double hyperbola(double t, double power) { return t / pow_of(1 + pow_of(t, power), 1 / power); }

Chromaticity moved_out(const Chromaticity& c, const Chromaticity& white) {
  const double scale = 1 / (1 - inset);
  return {white.x + (c.x - white.x) * scale, white.y + (c.y - white.y) * scale};
}

ColorMatrix inset_matrix() {
  const auto& [red, green, blue, white] = srgb_primaries;
  const Primaries wide{moved_out(red, white), moved_out(green, white), moved_out(blue, white), white};
  return product(inverse(to_xyz(wide)), to_xyz(srgb_primaries));
}

}  // namespace

double agx_curve(double logarithm) {
  if (logarithm < pivot) {
    const double toe = reach(pivot, pivot_value, toe_power);
    return pivot_value - toe * hyperbola(slope * (pivot - logarithm) / toe, toe_power);
  }
  const double shoulder = reach(1 - pivot, 1 - pivot_value, shoulder_power);
  return pivot_value + shoulder * hyperbola(slope * (logarithm - pivot) / shoulder, shoulder_power);
}

Agx::Agx() : inset_(inset_matrix()), outset_(inverse(inset_)) {
  for (std::size_t i = 0; i <= steps; ++i) table_.push_back(agx_curve(double(i) / steps));
}

double Agx::curve(double linear) const {
  if (!(linear > 0)) return table_.front();
  const double stops = log2_of(linear / middle_grey) + stops_below;
  const double place = std::clamp(stops / (stops_below + stops_above), 0.0, 1.0) * steps;
  const std::size_t i = std::min(std::size_t(place), steps - 1);
  return table_[i] + (table_[i + 1] - table_[i]) * (place - double(i));
}

Rgb Agx::displayed(const Rgb& color) const {
  std::array<double, 3> channels = transformed(inset_, std::array<double, 3>{color.r, color.g, color.b});
  for (double& channel : channels) channel = curve(channel);
  channels = transformed(outset_, channels);
  for (double& channel : channels) channel = pow_of(std::clamp(channel, 0.0, 1.0), display_gamma);
  return {float(channels[0]), float(channels[1]), float(channels[2])};
}

}  // namespace twinray
