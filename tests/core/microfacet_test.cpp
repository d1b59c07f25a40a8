// SPDX-License-Identifier: Apache-2.0
#include "core/microfacet.h"

#include "tests/support/catch.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

const Ggx facet_distributions[] = {Ggx(0.001f), Ggx(0.05f),      Ggx(0.3f),
                                   Ggx(1.0f),   Ggx(0.1f, 0.6f), Ggx(0.8f, 0.02f)};
constexpr int rows = 24, columns = 16;
const float facet_cosines[] = {1.0f, 0.8f, 0.3f, 0.05f};

/// Calls f(m, solid angle, cell) over facet normals, in steps of the angle a and the azimuth of their slopes
/// alpha tan(a) (cos, sin), so that narrow peaks are seen as well as wide ones.
template <class Function>
void visit_normals(const Ggx& ggx, int parts, const Function& f) {
  const int rings = rows * parts, turns = columns * parts;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < turns; ++j) {
      const double a = 0.5 * M_PI * (i + 0.5) / rings, phi = 2 * M_PI * (j + 0.5) / turns, t = std::tan(a);
      const double x = ggx.alpha_x() * t * std::cos(phi), y = ggx.alpha_y() * t * std::sin(phi);
      const double z = 1 / std::sqrt(1 + x * x + y * y);
      const double slopes = ggx.alpha_x() * ggx.alpha_y() * t * (1 + t * t) * M_PI * M_PI / rings / turns;
      f(Vec3{float(x * z), float(y * z), float(z)}, slopes * z * z * z,
        std::size_t(i / parts * columns + j / parts));
    }
}

template <class Function>
double over_normals(const Ggx& ggx, const Function& f) {
  double sum = 0;
  visit_normals(ggx, 32, [&](const Vec3& m, double area, std::size_t) { sum += f(m) * area; });
  return sum;
}

}  // namespace

TEST_CASE("the facets' projected area is the surface's") {
  for (const Ggx& ggx : facet_distributions) {
    CAPTURE(ggx.alpha_x(), ggx.alpha_y());
    CHECK(over_normals(ggx, [&](const Vec3& m) { return ggx.density(m) * m.z; }) == Approx(1).epsilon(2e-3));
  }
}

TEST_CASE("the facets that a direction sees have its projected area") {
  for (const Ggx& ggx : facet_distributions)
    for (const float cosine : facet_cosines) {
      const Vec3 w = direction_at(cosine);
      CAPTURE(ggx.alpha_x(), ggx.alpha_y(), cosine);
      CHECK(over_normals(ggx, [&](const Vec3& m) { return ggx.visible_density(w, m); }) ==
            Approx(1).epsilon(5e-3));
    }
}

TEST_CASE("visible normals have the stated density") {
  constexpr int samples = 60000, count = int(std::size(facet_distributions) * std::size(facet_cosines));
  for (const Ggx& ggx : facet_distributions)
    for (const float cosine : facet_cosines) {
      const Vec3 w = direction_at(cosine);
      CAPTURE(ggx.alpha_x(), ggx.alpha_y(), cosine);
      test::Random random(5);
      test::Grid grid(columns, rows);
      for (int i = 0; i < samples; ++i) {
        const float u = random.unit();
        const float v = random.unit();
        const Vec3 m = ggx.sample_visible(w, {u, v});
        REQUIRE(m.z >= 0);
        REQUIRE(std::fabs(length(m) - 1) < 1e-6f);
        REQUIRE(dot(w, m) > -1e-6f);
        const double x = m.x / ggx.alpha_x(), y = m.y / ggx.alpha_y(), phi = std::atan2(y, x);
        grid.add((phi < 0 ? phi + 2 * M_PI : phi) / (2 * M_PI),
                 std::atan2(std::hypot(x, y), m.z) / (0.5 * M_PI));
      }
      std::vector<double> expected(std::size_t(rows * columns));
      visit_normals(ggx, 24, [&](const Vec3& m, double area, std::size_t cell) {
        expected[cell] += samples * area * double(ggx.visible_density(w, m));
      });
      test::check_counts(grid.counts(), expected, count, 0.06);
    }
}

TEST_CASE("masking is 1 along the normal, falls towards the horizon and is correlated by height") {
  for (const Ggx& ggx : facet_distributions) {
    CHECK(ggx.masking({0, 0, 1}) == 1);
    float last = 1;
    for (const float cosine : {0.9f, 0.5f, 0.1f, 0.01f, 1e-6f}) {
      const float now = ggx.masking(direction_at(cosine));
      CHECK(now <= last);
      CHECK(now > 0);
      last = now;
      const float both = ggx.shadowing_masking(direction_at(cosine), direction_at(0.5f));
      CHECK(both >= now * ggx.masking(direction_at(0.5f)));
      CHECK(both <= std::min(now, ggx.masking(direction_at(0.5f))));
    }
  }
}

}  // namespace twinray
