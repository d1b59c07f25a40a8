// SPDX-License-Identifier: Apache-2.0
#include "core/observer.h"

namespace twinray {

std::span<const Observed> observer() {
  static constexpr Observed curves[]{
#include "core/observer.inc"
  };
  return curves;
}

Observed between(const Observed& a, const Observed& b, double part) {
  const auto mix = [part](double x, double y) { return x + part * (y - x); };
  return {mix(a.wavelength, b.wavelength), mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z),
          mix(a.daylight, b.daylight)};
}

std::array<double, 3> to_rgb(const Xyz& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
          -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

}  // namespace twinray
