// SPDX-License-Identifier: Apache-2.0
#include "core/blackbody.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elementary.h"
#include "core/observer.h"

namespace twinray {
namespace {

constexpr double hc_over_k = 1.438776877e7;  // nm K

// Of the table, in kelvin; its steps are even ones of the logarithm. Less hot than that, nothing is seen.
constexpr double coldest = 500, hottest = 1e6;
constexpr int steps = 1 << 12;

Rgb glow_of(double kelvin) {
  constexpr double peak = 2.897771955e6;  // Wien's law: the wavelength of the greatest radiance, in nm K.
  const double greatest = planck(peak / kelvin, kelvin);
  const auto color = to_rgb(seen([&](const Observed& o) { return planck(o.wavelength, kelvin) / greatest; }));
  const auto channel = [](double c) { return float(std::max(0.0, c)); };
  return {channel(color[0]), channel(color[1]), channel(color[2])};
}

double octaves() {
  static const double all = log2_of(hottest / coldest);
  return all;
}

std::vector<Rgb> make_table() {
  std::vector<Rgb> table;
  for (int i = 0; i <= steps; ++i) table.push_back(glow_of(coldest * exp2_of(octaves() * i / steps)));
  return table;
}

}  // namespace

double planck(double wavelength, double kelvin) {
  constexpr double log2_e = 1.4426950408889634;
  const double x = wavelength / 560;  // about 1, so that nothing overflows
  return 1 / (x * x * x * x * x * (exp2_of(log2_e * hc_over_k / (wavelength * kelvin)) - 1));
}

Rgb blackbody_glow(double kelvin) {
  static const std::vector<Rgb> table = make_table();
  if (!(kelvin >= coldest)) return {};
  const double place = log2_of(std::min(kelvin, hottest) / coldest) / octaves() * steps;
  const int below = std::min(int(place), steps - 1);
  const float part = float(place - below);
  const Rgb &a = table[std::size_t(below)], &b = table[std::size_t(below) + 1];
  return a * (1 - part) + b * part;
}

}  // namespace twinray
