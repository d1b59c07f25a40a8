// SPDX-License-Identifier: Apache-2.0
#include "core/measured_brdf.h"

#include <cmath>
#include <numeric>

#include "core/bsdf.h"
#include "core/scene.h"
#include "core/shading_map.h"
#include "tests/support/error_text.h"
#include "tests/support/lobe_checks.h"
#include "tests/support/measured_facets.h"

namespace twinray {
namespace {

using test::direction_at;
using test::error_text;
using test::measured_facets;

const Rgb facet_color{0.9f, 0.5f, 0.2f};

/// Some direction above the surface, at an azimuth of its own.
Vec3 above(test::Random& random, float least_cosine) {
  Vec3 w;
  do w = normalize(random.in_ball());
  while (std::fabs(w.z) < least_cosine);
  w.z = std::fabs(w.z);
  return w;
}

Vec3 turned(const Vec3& w, double angle) {
  return {float(std::cos(angle) * w.x - std::sin(angle) * w.y),
          float(std::sin(angle) * w.x + std::cos(angle) * w.y), w.z};
}

/// The largest difference to what the facets reflect, relative to the most of it.
double worst_error(const MeasuredBrdf& brdf, const Ggx& facets, float least_cosine) {
  test::Random random(8);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 wo = above(random, least_cosine), wi = above(random, least_cosine);
    const Rgb found = brdf.evaluate(wo, wi).value, exact = test::facets_value(facets, facet_color, wo, wi);
    const double most = double(test::facets_value(facets, facet_color, wo, {-wo.x, -wo.y, wo.z}).r);
    worst = std::max(worst, std::fabs(double(found.r) - double(exact.r)) / most);
    if (exact.r > 1e-3f) CHECK(found.g / found.r == Approx(facet_color.g / facet_color.r).epsilon(1e-4));
  }
  return worst;
}

}  // namespace

TEST_CASE("facets that were measured reflect what they do in closed form, from any side") {
  const Ggx even(0.4f), uneven(0.25f, 0.5f);
  CHECK(worst_error(MeasuredBrdf(measured_facets(even, facet_color, 24, 1, 64)), even, 0.2f) < 0.02);
  CHECK(worst_error(MeasuredBrdf(measured_facets(uneven, facet_color, 12, 33, 48)), uneven, 0.3f) < 0.05);
  // Few tables: the error shows.
  CHECK(worst_error(MeasuredBrdf(measured_facets(even, facet_color, 3, 1, 8)), even, 0.2f) > 0.05);
}

TEST_CASE("a measured material is sampled with its density") {
  const MeasuredBrdf even(measured_facets(Ggx(0.4f), facet_color)),
      uneven(measured_facets(Ggx(0.3f, 0.6f), facet_color, 6, 9));
  const Measured model{std::make_shared<const MeasuredBrdf>(even)};
  for (const float cosine : {1.0f, 0.7f, 0.3f, 0.05f}) {
    CAPTURE(cosine);
    test::check_sampling(MeasuredLobe(even, false), direction_at(cosine), 12, 24);
    test::check_sampling(MeasuredLobe(uneven, false), direction_at(cosine), 12, 24);
    test::check_sampling(MeasuredLobe(uneven, true), direction_at(cosine), 12, 24);
  }
}

TEST_CASE("what is sampled of a measured material sums up to what its values do") {
  const MeasuredBrdf brdf(measured_facets(Ggx(0.4f), facet_color, 12, 1, 48));
  for (const float cosine : {0.9f, 0.5f}) {
    const Rgb sum = test::scattered(MeasuredLobe(brdf, false), direction_at(cosine));
    CHECK(test::sampled_albedo(MeasuredLobe(brdf, false), direction_at(cosine)).r ==
          Approx(sum.r).epsilon(0.01));
    double exact = 0;
    test::SphereGrid::visit(16, [&](const Vec3& wi, double area, std::size_t) {
      if (wi.z <= 0) return;
      exact += area * double(wi.z * test::facets_value(Ggx(0.4f), facet_color, direction_at(cosine), wi).r);
    });
    CHECK(double(sum.r) == Approx(exact).epsilon(0.01));
  }
  CHECK(brdf.albedo().r ==
        Approx(test::scattered(MeasuredLobe(brdf, false), direction_at(0.7071f)).r).epsilon(0.03));
  CHECK(brdf.albedo().b == Approx(brdf.albedo().r * facet_color.b / facet_color.r));
}

TEST_CASE("a material of one azimuth looks the same however it is turned, and one of many does not") {
  const MeasuredBrdf even(measured_facets(Ggx(0.3f), facet_color)),
      uneven(measured_facets(Ggx(0.2f, 0.5f), facet_color, 6, 17));
  CHECK_FALSE(even.is_anisotropic());
  CHECK(uneven.is_anisotropic());
  CHECK_FALSE(is_anisotropic(SurfaceModel(test::measured_material(facet_color))));
  CHECK(is_anisotropic(SurfaceModel(test::measured_material(facet_color, 9))));
  test::Random random(9);
  double differs = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 wo = above(random, 0.3f), wi = above(random, 0.3f);
    const float value = even.evaluate(wo, wi).value.r;
    CHECK(even.evaluate(turned(wo, 2), turned(wi, 2)).value.r == Approx(value).epsilon(2e-3).margin(1e-4));
    differs = std::max(differs, std::fabs(double(uneven.evaluate(wo, wi).value.r) -
                                          double(uneven.evaluate(turned(wo, 2), turned(wi, 2)).value.r)));
  }
  CHECK(differs > 0.1);
}

TEST_CASE("azimuths of a half or a quarter of the circle stand for the rest of it") {
  const Ggx facets(0.2f, 0.5f);
  const MeasuredBrdf whole(measured_facets(facets, facet_color, 6, 33, 49)),
      half(measured_facets(facets, facet_color, 6, 17, 49, 2)),
      quarter(measured_facets(facets, facet_color, 6, 9, 49, 4));
  // What lies between nodes differs a little; a direction that was mirrored wrongly, much.
  test::Random random(10);
  double of_half = 0, of_quarter = 0, of_mirrored = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 wo = above(random, 0.4f), wi = above(random, 0.4f);
    const auto apart = [&](const MeasuredBrdf& brdf, const Vec3& light) {
      const double most = double(test::facets_value(facets, facet_color, wo, {-wo.x, -wo.y, wo.z}).g);
      return std::fabs(double(brdf.evaluate(wo, light).value.g) - double(whole.evaluate(wo, wi).value.g)) /
             most;
    };
    of_half = std::max(of_half, apart(half, wi));
    of_quarter = std::max(of_quarter, apart(quarter, wi));
    of_mirrored = std::max(of_mirrored, apart(quarter, {-wi.x, wi.y, wi.z}));
  }
  CHECK(of_half < 0.05);
  CHECK(of_quarter < 0.05);
  CHECK(of_mirrored > 0.5);
  for (const float x : {-0.5f, 0.5f})
    for (const float y : {-0.3f, 0.3f}) {
      const Vec3 wo{x, y, std::sqrt(1 - x * x - y * y)};
      test::check_sampling(MeasuredLobe(half, false), wo, 8, 24);
      test::check_sampling(MeasuredLobe(quarter, false), wo, 8, 24);
    }
}

TEST_CASE("half of the azimuths stands for a material that is the same turned by half a turn, not mirrored") {
  const auto leaning = [](BrdfMeasurement m) {
    std::vector<float> ndf = m.ndf.values();
    const std::size_t nodes = m.ndf.width();
    for (std::size_t y = 0; y < nodes; ++y)
      for (std::size_t x = 0; x < nodes; ++x)
        if (4 * y / nodes % 2 == 0) ndf[y * nodes + x] *= 3;
    m.ndf = SquareTable<float>(nodes, nodes, ndf);
    return MeasuredBrdf(std::move(m));
  };
  const Ggx facets(0.4f, 0.5f);
  const MeasuredBrdf whole = leaning(measured_facets(facets, facet_color, 6, 33, 33)),
                     half = leaning(measured_facets(facets, facet_color, 6, 17, 33, 2));
  CHECK(half.folds() == 2);
  test::Random random(12);
  double apart = 0, mirrored = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 wo = above(random, 0.4f), wi = above(random, 0.4f);
    const auto value = double(whole.evaluate(wo, wi).value.g);
    const Vec3 side_o{wo.x, -wo.y, wo.z}, side_i{wi.x, -wi.y, wi.z};
    apart += std::fabs(double(half.evaluate(wo, wi).value.g) - value);
    mirrored += std::fabs(double(half.evaluate(side_o, side_i).value.g) - value);
  }
  CHECK(apart < 0.05 * mirrored);
}

TEST_CASE("from behind, a measured material is the point reflection of itself") {
  // Facets that are even in x and y do not show it: these reflect more towards +x.
  BrdfMeasurement leaning = measured_facets(Ggx(0.4f, 0.5f), facet_color, 6, 9);
  std::vector<float> ndf = leaning.ndf.values();
  const std::size_t nodes = leaning.ndf.width();
  for (std::size_t y = nodes / 4; y < nodes / 2; ++y)
    for (std::size_t x = 0; x < nodes; ++x) ndf[y * nodes + x] *= 3;
  leaning.ndf = SquareTable<float>(nodes, nodes, ndf);
  const auto brdf = std::make_shared<const MeasuredBrdf>(leaning);
  const SurfaceModel model = Measured{brdf};
  test::Random random(11);
  double differs = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 wo = above(random, 0.2f), wi = above(random, 0.2f);
    // Seen from behind, the frame has the same x axis, and y and z point the other way.
    const auto in_front = [](const Vec3& w) { return Vec3{-w.x, w.y, w.z}; };
    const BsdfValue behind = Bsdf(model, Side::inside).evaluate(wo, wi);
    CHECK(behind.value == brdf->evaluate(in_front(wo), in_front(wi)).value);
    differs = std::max(differs, std::fabs(double(behind.value.r) - double(brdf->evaluate(wo, wi).value.r)));
  }
  CHECK(differs > 0.1);
}

TEST_CASE("values that are not relative to facets are those of the light itself") {
  BrdfMeasurement even = measured_facets(Ggx(0.4f), facet_color);
  even.is_relative_to_facets = false;
  even.reflected = SquareTable<Rgb>(2, 2, std::vector<Rgb>(6 * 4, Rgb{0.5f, 0.25f, 0.125f}));
  const MeasuredBrdf brdf(even);
  const Vec3 wo = direction_at(0.8f), wi = direction_at(0.6f);
  CHECK(brdf.evaluate(wo, wi).value.r * wi.z == Approx(0.5));
  CHECK(brdf.evaluate(wo, wi).value.b * wi.z == Approx(0.125));
}

TEST_CASE("a measured material reflects to the viewer's side, and nothing where its facets show no area") {
  const MeasuredBrdf brdf(measured_facets(Ggx(0.4f), facet_color));
  CHECK(brdf.evaluate(direction_at(0.5f), test::flipped(direction_at(0.5f))).pdf == 0);
  CHECK(brdf.evaluate(test::flipped(direction_at(0.5f)), direction_at(0.5f)).pdf == 0);
  CHECK(brdf.sample(test::flipped(direction_at(0.5f)), {0.5f, 0.5f}).pdf == 0);
  BrdfMeasurement hidden = measured_facets(Ggx(0.4f), facet_color);
  hidden.sigma = SquareTable<float>(2, 2, {0, 0, 0, 0});
  CHECK(MeasuredBrdf(hidden).evaluate(direction_at(0.5f), direction_at(0.4f)).pdf == 0);
  CHECK(MeasuredBrdf(hidden).albedo() == Rgb{});
}

TEST_CASE("measurements that cannot be are refused with what is wrong") {
  const auto error = [](const auto& change) {
    BrdfMeasurement m = measured_facets(Ggx(0.4f), facet_color, 3, 5, 4);
    change(m);
    return error_text([&] { MeasuredBrdf{std::move(m)}; });
  };
  Scene scene;
  scene.materials = {{"paint", Measured{}}};
  CHECK(error_text([&] { check_scene(scene); }) == "material 0 is a measured one without a measurement");
  using M = BrdfMeasurement;
  CHECK(error([](M&) {}) == "");
  CHECK(error([](M& m) { m.phi.clear(); }) == "a measurement without phi");
  CHECK(error([](M& m) { m.theta.clear(); }) == "a measurement without theta");
  CHECK(error([](M& m) { m.theta[1] = m.theta[2]; }) ==
        "the angles of a measurement's theta do not increase within their range");
  CHECK(error([](M& m) { m.theta[2] = 1.6f; }) ==
        "the angles of a measurement's theta do not increase within their range");
  CHECK(error([](M& m) { m.phi[4] = NAN; }) ==
        "the angles of a measurement's phi do not increase within their range");
  CHECK(error([](M& m) {
          m.phi = {0, 0.5f, 1, 1.5f, 1.8f};
        }) == "the azimuths of a measurement must go around the circle, a half or a quarter of it");
  const SquareTable<float> two(2, 2, std::vector<float>(8, 1.0f));
  CHECK(error([&](M& m) { m.ndf = two; }) ==
        "the number of slices in the table ndf of a measurement is 2; it must be 1");
  CHECK(error([&](M& m) { m.sigma = two; }) ==
        "the number of slices in the table sigma of a measurement is 2; it must be 1");
  CHECK(error([&](M& m) { m.vndf = two; }) ==
        "the number of slices in the table vndf of a measurement is 2; it must be 15");
  CHECK(error([&](M& m) { m.luminance = two; }) ==
        "the number of slices in the table luminance of a measurement is 2; it must be 15");
  CHECK(error([](M& m) { m.reflected = SquareTable<Rgb>(2, 2, std::vector<Rgb>(4)); }) ==
        "the number of slices in the table reflected of a measurement is 1; it must be 15");
  CHECK(error([](M& m) {
          m.sigma = SquareTable<float>(2, 2, {1, 1, -1, 1});
        }) == "the table sigma of a measurement has a number that is negative or not finite");
  CHECK(error([](M& m) {
          m.ndf = SquareTable<float>(2, 2, {1, 1, INFINITY, 1});
        }) == "the table ndf of a measurement has a number that is negative or not finite");
  CHECK(error([](M& m) {
          m.reflected = SquareTable<Rgb>(2, 2, std::vector<Rgb>(60, Rgb{1, NAN, 1}));
        }) == "what a measured material reflects is negative or not finite");
}

}  // namespace twinray
