// SPDX-License-Identifier: Apache-2.0
// Films against the waves themselves: each wavelength through the matrices of its layers (Abeles), both
// polarisations, and what an observer sees of them under daylight.
#include "core/thin_film.h"

#include <array>
#include <cmath>
#include <complex>

#include "core/fresnel.h"
#include "core/observer.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

using Complex = std::complex<double>;

/// What a layer of index `film` between `above` and `base` reflects of one polarisation of one wavelength.
double reflected(double cosine, double above, double film, double base, double phase, bool is_along) {
  const double sine = above * std::sqrt(1 - cosine * cosine);
  const auto cosine_in = [&](double n) { return std::sqrt(Complex(1 - sine * sine / (n * n))); };
  const auto admittance = [&](double n) { return is_along ? n / cosine_in(n) : n * cosine_in(n); };
  const Complex delta = phase * cosine_in(film), i(0, 1);
  const Complex b = std::cos(delta) + i * std::sin(delta) * admittance(base) / admittance(film);
  const Complex c = i * admittance(film) * std::sin(delta) + admittance(base) * std::cos(delta);
  return std::norm((admittance(above) * b - c) / (admittance(above) * b + c));
}

/// As an observer sees it under daylight.
Rgb seen(float cosine, double thickness, double above, double film, double base) {
  Xyz of_film, of_all;
  for (const Observed& o : observer()) {
    const double phase = 2 * 3.14159265358979323846 * film * thickness / o.wavelength;
    const double r = (reflected(double(cosine), above, film, base, phase, false) +
                      reflected(double(cosine), above, film, base, phase, true)) /
                     2;
    of_film.x += o.x * o.daylight * r, of_film.y += o.y * o.daylight * r, of_film.z += o.z * o.daylight * r;
    of_all.x += o.x * o.daylight, of_all.y += o.y * o.daylight, of_all.z += o.z * o.daylight;
  }
  const auto part = to_rgb(of_film), whole = to_rgb(of_all);
  return {float(part[0] / whole[0]), float(part[1] / whole[1]), float(part[2] / whole[2])};
}

struct Layers {
  float above, film, base;
};
/// Films denser and thinner than both, or than one of their sides; on something like a metal.
const Layers layers[] = {{1, 1.4f, 1.5f}, {1, 1.33f, 1}, {1, 2.4f, 1.5f}, {1.5f, 1.3f, 2}, {1, 1.4f, 20}};

}  // namespace

TEST_CASE("a film reflects what waves in it do, at every thickness and angle") {
  for (const auto& [above, film, base] : layers)
    for (const float thickness : {0.0f, 50.0f, 250.0f, 500.0f, 1200.0f, 2500.0f})
      for (const float cosine : {1.0f, 0.8f, 0.5f, 0.2f}) {
        if (above > film && std::sqrt(1 - cosine * cosine) * above > film) continue;  // It is no film then.
        CAPTURE(above, film, base, thickness, cosine);
        const Rgb expected = within_unit(seen(cosine, thickness, above, film, base));
        const Rgb found = ThinFilm(thickness, film, above).reflectance(cosine, white * (base / above));
        CHECK(found.r == Approx(expected.r).margin(3e-3));
        CHECK(found.g == Approx(expected.g).margin(3e-3));
        CHECK(found.b == Approx(expected.b).margin(3e-3));
      }
}

TEST_CASE("daylight is white to the observer") {
  Xyz daylight;
  for (const Observed& o : observer())
    daylight.x += o.x * o.daylight, daylight.y += o.y * o.daylight, daylight.z += o.z * o.daylight;
  for (const double channel : to_rgb(daylight)) CHECK(channel / daylight.y == Approx(1).margin(1e-3));
}

TEST_CASE("each channel has the index of its own base") {
  const ThinFilm film(300, 1.4f);
  const Rgb bases{1.2f, 1.7f, 4}, all = film.reflectance(0.6f, bases);
  CHECK(all.r == Approx(film.reflectance(0.6f, white * 1.2f).r).margin(1e-4));
  CHECK(all.g == Approx(film.reflectance(0.6f, white * 1.7f).g).margin(1e-4));
  CHECK(all.b == Approx(film.reflectance(0.6f, white * 4.0f).b).margin(1e-4));
}

TEST_CASE("a film without a thickness is not there, and a thick one has no colour") {
  for (const float cosine : {1.0f, 0.4f, 0.1f}) {
    const float bare = fresnel_dielectric(cosine, 1.5f);
    const Rgb none = ThinFilm(0, 1.4f).reflectance(cosine, white * 1.5f);
    CHECK(none.g == Approx(bare).margin(2e-4));
    const Rgb thick = ThinFilm(1e6f, 1.4f).reflectance(cosine, white * 1.5f);
    CHECK(thick.r == thick.b);
  }
  CHECK(ThinFilm(300, 1.4f).reflectance(0, white * 1.5f).g == 1);
  // Light that the film does not let in.
  CHECK(ThinFilm(300, 1.2f, 1.6f).reflectance(0.3f, white).g == 1);
}

TEST_CASE("what goes in reflects as much as what comes out along the same way") {
  const PartialFilm above{ThinFilm(400, 1.4f), 0.75f}, below{ThinFilm(400, 1.4f), 0.75f, true};
  for (const float cosine : {1.0f, 0.8f, 0.5f, 0.2f}) {
    CAPTURE(cosine);
    const Rgb in = above.reflectance(cosine, 1.5f);
    const Rgb out = below.reflectance(refracted_cosine(cosine, 1.5f), 1 / 1.5f);
    CHECK(in.r == Approx(out.r).margin(1e-5));
    CHECK(in.b == Approx(out.b).margin(1e-5));
    const float bare = fresnel_dielectric(cosine, 1.5f);
    const Rgb whole = above.film.reflectance(cosine, white * 1.5f);
    CHECK(in.g == Approx(bare + (whole.g - bare) * 0.75f).margin(1e-6));
  }
  CHECK(below.reflectance(0.3f, 1 / 1.5f) == white);
}

TEST_CASE("waves that go the same way keep in step, and lose it by and by") {
  CHECK(mean_interference(0) == white);
  CHECK(mean_interference(275).g < -0.7f);
  CHECK(mean_interference(550).g > 0.6f);
  for (const float detour : {9000.0f, 9995.0f, film_coherence, 1e9f})
    CHECK(std::fabs(max_component(mean_interference(detour))) < 0.05f);
}

TEST_CASE("an index of refraction reflects what it is made for") {
  const Rgb index = index_of_reflectance({0.04f, 0.5f, 0.9f});
  CHECK(fresnel_dielectric(1, index.r) == Approx(0.04).epsilon(1e-4));
  CHECK(fresnel_dielectric(1, index.g) == Approx(0.5).epsilon(1e-4));
  CHECK(fresnel_dielectric(1, index.b) == Approx(0.9).epsilon(1e-4));
  CHECK(std::isfinite(index_of_reflectance(white).r));
}

}  // namespace twinray::test
