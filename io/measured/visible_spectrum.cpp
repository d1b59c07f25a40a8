// SPDX-License-Identifier: Apache-2.0
#include "io/measured/visible_spectrum.h"

#include <cstddef>

#include "core/observer.h"

namespace twinray {
namespace {

/// How much of the value at wavelength i there is at another wavelength.
double share(std::span<const float> wavelengths, std::size_t i, double at) {
  const auto middle = double(wavelengths[i]);
  if (at == middle) return 1;
  const bool is_above = at > middle;
  if (is_above ? i + 1 == wavelengths.size() : i == 0) return 1;
  const auto next = double(wavelengths[is_above ? i + 1 : i - 1]);
  const double part = (at - middle) / (next - middle);
  return part < 1 ? 1 - part : 0;
}

}  // namespace

std::vector<std::array<double, 3>> reflectance_weights(std::span<const float> wavelengths) {
  const std::array<double, 3> light = to_rgb(seen([](const Observed& o) { return o.daylight; }));
  std::vector<std::array<double, 3>> weights;
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    std::array<double, 3> lit =
        to_rgb(seen([&](const Observed& o) { return o.daylight * share(wavelengths, i, o.wavelength); }));
    for (std::size_t k = 0; k < 3; ++k) lit[k] /= light[k];
    weights.push_back(lit);
  }
  return weights;
}

PrimarySpectra primary_spectra() {
  static constexpr struct {
    float wavelength;
    Rgb value;
  } rows[]{{380, {0.0565f, 0, 1.1292f}},
           {400, {0.0563f, 0, 1.1287f}},
           {420, {0.0536f, 0, 1.1218f}},
           {440, {0.0350f, 0, 1.0661f}},
           {460, {0, 0, 0.8921f}},
           {480, {0, 0.2731f, 0.6069f}},
           {500, {0, 0.6899f, 0.2997f}},
           {520, {0, 1.0229f, 0.0667f}},
           {540, {0, 1.1179f, 0}},
           {560, {0, 0.9503f, 0}},
           {580, {0.2084f, 0.6210f, 0}},
           {600, {0.6330f, 0.2881f, 0.0008f}},
           {620, {0.9794f, 0.0753f, 0.0258f}},
           {640, {1.1559f, 0, 0.0426f}},
           {660, {1.2201f, 0, 0.0493f}},
           {680, {1.2380f, 0, 0.0512f}},
           {700, {1.2422f, 0, 0.0516f}},
           {720, {1.2432f, 0, 0.0517f}},
           {740, {1.2435f, 0, 0.0518f}}};
  PrimarySpectra spectra;
  for (const auto& [wavelength, value] : rows) {
    spectra.wavelengths.push_back(wavelength);
    spectra.values.push_back(value);
  }
  return spectra;
}

}  // namespace twinray
