// SPDX-License-Identifier: Apache-2.0
// How spectra look: the curves of the CIE's observer of 1931 (2 degrees) and its daylight, from 360 to 830 nm
// in steps of 5 nm, and the primaries of sRGB.
#pragma once
#include <array>
#include <cstddef>
#include <span>

namespace twinray {

/// What the observer sees of light of one wavelength (in nm), and how much of that daylight (D65) has.
struct Observed {
  double wavelength, x, y, z, daylight;
};
std::span<const Observed> observer();
/// So far from `a` to `b`, part in [0, 1].
Observed between(const Observed& a, const Observed& b, double part);

struct Xyz {
  double x = 0, y = 0, z = 0;
};

/// The sum over wavelengths of the observer's curves times value(Observed), in steps of 1 nm, as pbrt takes
/// it: a line of sodium is 2 nm wide.
template <typename Value>
Xyz seen(const Value& value) {
  Xyz sum;
  const auto add = [&](const Observed& o) {
    const double v = value(o);
    sum.x += o.x * v, sum.y += o.y * v, sum.z += o.z * v;
  };
  const std::span<const Observed> rows = observer();
  const int steps = int(rows[1].wavelength - rows[0].wavelength);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    for (int step = 0; step < steps; ++step) add(between(rows[i], rows[i + 1], double(step) / steps));
  add(rows.back());
  return sum;
}

/// By the primaries of sRGB (IEC 61966-2-1), linear, not clipped.
std::array<double, 3> to_rgb(const Xyz& c);

}  // namespace twinray
