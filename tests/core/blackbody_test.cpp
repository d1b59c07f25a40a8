// SPDX-License-Identifier: Apache-2.0
#include "core/blackbody.h"

#include <cmath>

#include "core/observer.h"
#include "tests/support/catch.h"

namespace twinray::test {

TEST_CASE("a black body's glow is its spectrum over the greatest radiance, seen by the observer") {
  for (const double kelvin : {700.0, 1500.0, 2856.0, 6504.0, 25000.0, 99000.0, 9e5}) {
    CAPTURE(kelvin);
    // The greatest of many wavelengths, rather than by Wien's law.
    double greatest = 0;
    for (double wavelength = 2; wavelength < 5000; wavelength += 0.25)
      greatest = std::max(greatest, planck(wavelength, kelvin));
    const auto color =
        to_rgb(seen([&](const Observed& o) { return planck(o.wavelength, kelvin) / greatest; }));
    const Rgb glow = blackbody_glow(kelvin);
    CHECK(double(glow.r) == Approx(std::max(0.0, color[0])).epsilon(1e-3));
    CHECK(double(glow.g) == Approx(std::max(0.0, color[1])).epsilon(1e-3));
    CHECK(double(glow.b) == Approx(std::max(0.0, color[2])).epsilon(1e-3));
  }
  // Embers are red, and nothing of the cold is seen.
  CHECK(blackbody_glow(1000).r > 3 * blackbody_glow(1000).g);
  CHECK(blackbody_glow(1000).b == 0);
  CHECK(blackbody_glow(499) == Rgb{});
  CHECK(blackbody_glow(-5000) == Rgb{});
  CHECK(blackbody_glow(std::nan("")) == Rgb{});
  CHECK(is_finite(blackbody_glow(500)));
  CHECK(blackbody_glow(1e300) == blackbody_glow(1e6));
}

TEST_CASE("planck's law is that of radiance per wavelength") {
  // By its constants in SI units, relative to the same at another wavelength and temperature.
  const auto radiance = [](double wavelength, double kelvin) {
    const double meters = wavelength * 1e-9;
    return std::pow(meters, -5) / std::expm1(6.62607015e-34 * 299792458.0 / (meters * 1.380649e-23 * kelvin));
  };
  for (const double kelvin : {1000.0, 3000.0, 30000.0})
    CHECK(planck(650, kelvin) / planck(450, 5000) ==
          Approx(radiance(650, kelvin) / radiance(450, 5000)).epsilon(1e-8).margin(0));
}

}  // namespace twinray::test
