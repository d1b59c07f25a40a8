// SPDX-License-Identifier: Apache-2.0
#include "core/lobes/hair.h"

#include <cmath>

#include "core/angle.h"
#include "core/fresnel.h"
#include "tests/support/lobe_checks.h"

namespace twinray {
namespace {

using test::direction_at;

/// Smooth enough that its lobes are seen one by one.
Hair narrow(const Rgb& reflectance) { return {reflectance, 0.1f, 0.1f, 0}; }

Vec3 fibre_direction(double sine, double azimuth) {
  const double cosine = std::sqrt(1 - sine * sine);
  return {float(sine), float(cosine * std::sin(azimuth)), float(cosine * std::cos(azimuth))};
}

/// The integral of f |cos| over a patch of a direction's angles to both sides.
double light_near(const HairLobe& lobe, const Vec3& wo, double sine, double azimuth, double half) {
  constexpr int parts = 160;
  double sum = 0;
  const double theta = std::asin(sine);
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const double t = theta + half * ((i + 0.5) / parts * 2 - 1);
      const Vec3 wi = fibre_direction(std::sin(t), azimuth + half * ((j + 0.5) / parts * 2 - 1));
      sum += double(lobe.evaluate(wo, wi).value.g) * std::fabs(double(wi.z)) * std::cos(t);
    }
  return sum * 4 * half * half / (parts * parts);
}

}  // namespace

TEST_CASE("a fibre is sampled with its density") {
  for (const Hair& hair : {Hair{}, Hair{{0.9f, 0.5f, 0.2f}, 0.4f, 0.6f, -5},
                           Hair{white, 0.8f, 0.3f, 10, 1.3f}, Hair{{0.5f, 0.5f, 0.9f}, 0.5f, 1, 0}}) {
    const HairLobe lobe(hair);
    for (const float cosine : {0.95f, 0.6f, 0.2f}) test::check_sampling(lobe, direction_at(cosine), 12);
  }
}

TEST_CASE("a white fibre scatters all light, and a dark one what its surface reflects, or less") {
  for (const float roughness : {0.15f, 0.3f, 0.7f, 1.0f})
    for (const float cosine : {1.0f, 0.7f, 0.3f}) {
      CAPTURE(roughness, cosine);
      const Vec3 wo = direction_at(cosine);
      const Hair hair{white, roughness, roughness, 2};
      CHECK(test::scattered(HairLobe(hair), wo, 32).g == Approx(1).epsilon(0.01));
      CHECK(test::sampled_albedo(HairLobe(hair), wo).g == Approx(1).epsilon(0.01));
      const float gamma = wo.y / std::sqrt(wo.y * wo.y + wo.z * wo.z);
      const float to_surface = std::sqrt(1 - wo.x * wo.x) * std::sqrt(1 - gamma * gamma);
      const Hair black{{1e-12f, 1e-12f, 1e-12f}, roughness, roughness, 2};
      CHECK(test::scattered(HairLobe(black), wo, 32).g ==
            Approx(double(fresnel_dielectric(to_surface, black.ior))).epsilon(0.02));
    }
}

TEST_CASE("a fibre reflects light as its surface does, and lets it through as a cylinder of glass does") {
  const HairLobe lobe(narrow(white));
  for (const double sine : {0.0, 0.4})
    for (const double gamma : {0.7, 0.5, -0.9}) {
      CAPTURE(sine, gamma);
      const Vec3 wo = fibre_direction(sine, gamma);
      const double cosine = std::sqrt(1 - sine * sine);
      // Both normals lie in the plane of the cross section: a ray keeps its angle to the fibre.
      const double across = std::sqrt(1.55 * 1.55 - sine * sine) / cosine;
      const double within = std::asin(std::sin(gamma) / across);
      const double reflected = double(fresnel_dielectric(float(cosine * std::cos(gamma)), 1.55f));
      CHECK(light_near(lobe, wo, -sine, -gamma, 0.5) == Approx(reflected).margin(0.012));
      CHECK(light_near(lobe, wo, -sine, gamma + 2 * within - 2 * gamma + M_PI, 0.5) ==
            Approx((1 - reflected) * (1 - reflected)).margin(0.03));
    }
}

TEST_CASE("scales turn what is reflected towards the root, and what goes through towards the tip") {
  const auto brightest = [](float tilt, double azimuth) {
    Hair hair = narrow(white);
    hair.scale_tilt = tilt;
    const HairLobe lobe(hair);
    double best = 0, most = -1;
    for (double theta = -0.5; theta < 0.5; theta += 0.002) {
      const Vec3 wi = fibre_direction(std::sin(theta), azimuth);
      const double light = double(lobe.evaluate({0, 0, 1}, wi).value.g) * std::fabs(double(wi.z));
      if (light > most) most = light, best = theta;
    }
    return best;
  };
  const double degrees = 5 * radians_per_degree;
  CHECK(brightest(0, 0) == Approx(0).margin(0.01));
  CHECK(brightest(5, 0) == Approx(2 * degrees).margin(0.01));
  CHECK(brightest(5, M_PI) == Approx(-degrees).margin(0.01));
}

TEST_CASE("light on its way through a fibre is absorbed by the colour that many of them have") {
  for (const float beta : {0.1f, 0.3f, 0.9f})
    for (const float c : {0.01f, 0.3f, 0.9f, 1.0f}) {
      const Rgb absorption = hair_absorption({c, c, 1}, beta);
      CHECK(hair_reflectance(absorption, beta).r == Approx(c).epsilon(1e-4));
      CHECK(absorption.b == 0);
      CHECK((absorption.r > 0) == (c < 1));
    }
  // Straight through, two radii.
  const Rgb color{0.3f, 0.3f, 0.3f};
  const double left = std::exp(-2 * double(hair_absorption(color, 0.1f).g));
  const Vec3 wo{0, 0, 1};
  CHECK(light_near(HairLobe(narrow(color)), wo, 0, M_PI, 0.5) ==
        Approx(left * light_near(HairLobe(narrow(white)), wo, 0, M_PI, 0.5)).epsilon(0.02));
}

TEST_CASE("looking from a direction first changes no bit of a fibre") {
  test::Random random(4);
  for (int i = 0; i < 300; ++i) {
    Vec3 wo = normalize(random.in_ball());
    wo.z = std::fabs(wo.z);
    const Vec3 wi = normalize(random.in_ball());
    HairLobe lobe(Hair{}), seen(Hair{});
    seen.look_from(wo);
    CHECK(seen.evaluate(wo, wi).value == lobe.evaluate(wo, wi).value);
    CHECK(seen.evaluate(wo, wi).pdf == lobe.evaluate(wo, wi).pdf);
    const float draw = random.unit();
    CHECK(seen.sample(wo, draw, {0.3f, 0.6f}).wi == lobe.sample(wo, draw, {0.3f, 0.6f}).wi);
  }
}

}  // namespace twinray
