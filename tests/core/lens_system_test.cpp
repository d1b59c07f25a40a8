// SPDX-License-Identifier: Apache-2.0
#include "core/lens_system.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "core/angle.h"
#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

/// A double Gauss lens of 50 mm, in millimeters (scenes/double-gauss.dat).
std::vector<LensSurface> double_gauss() {
  return {{29.475, 3.76, 1.67, 12.6},  {84.83, 0.12, 1, 12.6},    {19.275, 4.025, 1.67, 11.5},
          {40.77, 3.275, 1.699, 11.5}, {12.75, 5.705, 1, 9},      {0, 4.5, 0, 8.55},
          {-14.495, 1.18, 1.603, 8.5}, {40.77, 6.065, 1.658, 10}, {-20.385, 0.19, 1, 10},
          {437.065, 3.22, 1.717, 10},  {-39.73, 5, 1, 10}};
}

/// Glass of two surfaces.
std::vector<LensSurface> single_lens(double front, double back, double thickness, double aperture = 5) {
  return {{front, thickness, 1.5, aperture}, {back, 60, 1, aperture}};
}

/// A lens with a small stop right before the film's side: what the film sees of the pupil is the stop.
LensSystem lens_with_stop(double stop, double film_radius) {
  return LensSystem({{100, 4, 1.5, 30}, {-100, 2, 1, 30}, {0, 40, 1, stop}}, film_radius);
}

constexpr int draws = 200;

/// Calls take(sight) for an even grid of draws.
template <typename Take>
void for_each_sight(const LensSystem& lens, Vec2 film, const Take& take) {
  for (int i = 0; i < draws; ++i)
    for (int k = 0; k < draws; ++k)
      take(lens.sight(film, {(float(i) + 0.5f) / draws, (float(k) + 0.5f) / draws}));
}

double mean_light(const LensSystem& lens, Vec2 film) {
  double sum = 0;
  for_each_sight(lens, film, [&](const LensSystem::Sight& sight) { sum += double(sight.light); });
  return sum / draws / draws;
}

}  // namespace

TEST_CASE("cardinal points are those of the lensmaker's equation for thick lenses") {
  for (const auto& [r1, r2, d] : {std::array{50.0, -80.0, 6.0}, {30.0, 90.0, 4.0}, {1e9, -40.0, 10.0}}) {
    const double n = 1.5, power = (n - 1) * (1 / r1 - 1 / r2 + (n - 1) * d / (n * r1 * r2));
    const CardinalPoints points = cardinal_points(single_lens(r1, r2, d));
    CHECK(points.focal_length == Approx(1 / power));
    // -f (n - 1) d / (n r2) behind the front vertex, and -f (n - 1) d / (n r1) behind the one at the back.
    CHECK(points.rear_principal == Approx(-(n - 1) * d / (power * n * r1)).margin(1e-9));
    CHECK(points.front_principal == Approx(-d - (n - 1) * d / (power * n * r2)).margin(1e-9));
  }
}

TEST_CASE("the double Gauss lens has the focal length that it is known for") {
  CHECK(cardinal_points(double_gauss()).focal_length == Approx(50).epsilon(0.01));
}

TEST_CASE("what lies in the plane in focus is sharp and what lies elsewhere is not") {
  const double distance = 900;
  const LensSystem lens(focused(double_gauss(), distance), 21.6);
  CHECK(lens.focus_distance() == Approx(distance).epsilon(1e-9));
  CHECK(lens.image_distance() < 2 * lens.focal_length());  // Of two such places of the film the nearer one.
  const Vec2 film{-4, 2.5f};
  const auto spread_at = [&](double z) {
    double least = 1e9, most = -1e9, mean = 0;
    int count = 0;
    for_each_sight(lens, film, [&](const LensSystem::Sight& sight) {
      if (sight.light == 0) return;
      const double t = (z - double(sight.origin.z)) / double(sight.direction.z);
      const double x = double(sight.origin.x) + t * double(sight.direction.x);
      least = std::min(least, x), most = std::max(most, x), mean += x, ++count;
    });
    return std::pair(most - least, mean / count);
  };
  const auto [sharp, middle] = spread_at(distance);
  CHECK(sharp < 2);  // The lens's own faults; at f/2 the cone is 25 mm wide where it leaves.
  CHECK(spread_at(2 * distance).first > 20);
  CHECK(spread_at(distance / 2).first > 10);
  // A pinhole at the principal planes has this magnification: the picture is upside down.
  const double between =
      cardinal_points(double_gauss()).rear_principal - cardinal_points(double_gauss()).front_principal;
  CHECK(middle ==
        Approx(4 * (distance - lens.image_distance() - between) / lens.image_distance()).epsilon(0.01));
}

TEST_CASE("on the axis the film gets the light of the cone that the stop leaves") {
  for (const double stop : {0.5, 4.0, 15.0}) {
    // The integral of cos^4 over the disc of the stop, over its squared distance: pi sin^2 of the half angle.
    const double expected = pi_double * stop * stop / (stop * stop + 40 * 40);
    CHECK(mean_light(lens_with_stop(stop, 20), {0, 0}) == Approx(expected).epsilon(0.01));
  }
}

TEST_CASE("light falls off towards the corners by cos to the fourth where nothing is in its way") {
  const LensSystem lens = lens_with_stop(0.5, 20);
  const double axis = mean_light(lens, {0, 0});
  for (const float away : {5.0f, 10.0f, 19.9f}) {
    const double cosine = 40 / std::hypot(40.0, double(away));
    CHECK(mean_light(lens, {away, 0}) / axis == Approx(std::pow(cosine, 4)).epsilon(0.02));
    CHECK(mean_light(lens, {away * -0.6f, away * 0.8f}) / axis == Approx(std::pow(cosine, 4)).epsilon(0.02));
  }
}

TEST_CASE("bounds of the pupil cut nothing off, and what lies beyond the film has none") {
  const std::vector<LensSurface> surfaces = focused(double_gauss(), 1000);
  const LensSystem known(surfaces, 21.6), unknown(surfaces, 1e-3);
  for (const float away : {0.2f, 7.0f, 15.0f, 21.0f, 21.6f}) {
    const double expected = mean_light(unknown, {away, 0});
    CHECK(expected > 0);
    CHECK(mean_light(known, {away, 0}) == Approx(expected).epsilon(0.03));
    CHECK(mean_light(known, {0, -away}) == Approx(expected).epsilon(0.03));
  }
}

TEST_CASE("a pupil that moves with the film's point is followed, beyond the film, too") {
  // With the stop before the glass its image is far away, and seen elsewhere from each point of the film.
  const std::vector<LensSurface> surfaces{{0, 10, 1, 3}, {50, 5, 1.5, 30}, {-50, 60, 1, 30}};
  const LensSystem known(surfaces, 20), unknown(surfaces, 1e-3);
  const double axis = mean_light(known, {0, 0});
  for (const float away : {0.3f, 9.0f, 19.0f}) {
    CHECK(mean_light(known, {away, 0}) == Approx(mean_light(unknown, {0, away})).epsilon(0.03));
    CHECK(mean_light(known, {away, 0}) > 0.5 * axis);
  }
}

TEST_CASE("a surface's rim stops light, so the corners are darker than by the stop alone") {
  const LensSystem lens(focused(double_gauss(), 1000), 21.6);
  const double cosine = lens.image_distance() / std::hypot(lens.image_distance(), 20);
  CHECK(mean_light(lens, {20, 0}) < 0.7 * std::pow(cosine, 4) * mean_light(lens, {0, 0}));
}

TEST_CASE("a nearly flat surface is as good as a flat one, and glass that is flat refracts") {
  const auto light = [](double back) {
    return mean_light(LensSystem({{50, 5, 1.5, 10}, {back, 90, 1, 10}}, 20), {6, 2});
  };
  const double flat = light(0);
  CHECK(flat > 0);
  CHECK(cardinal_points({{50, 5, 1.5, 10}, {0, 90, 1, 10}}).focal_length == Approx(100));
  for (const double back : {1e7, -1e7, 1e12, -1e16, 1e20, -1e30})
    CHECK(light(back) == Approx(flat).epsilon(1e-4));
}

TEST_CASE("a pupil is found however small its stop is") {
  std::vector<LensSurface> surfaces = focused(double_gauss(), 1000);
  std::map<float, double> wide;
  for (const double radius : {1.0, 0.1, 0.01}) {
    surfaces[5].aperture_radius = radius;
    const LensSystem lens(surfaces, 21.6);
    for (const float away : {0.0f, 11.0f, 21.0f}) {
      int through = 0;
      for_each_sight(lens, {away, 0}, [&](const LensSystem::Sight& sight) { through += sight.light > 0; });
      CHECK(through > draws * draws / 20);
      const double light = mean_light(lens, {away, 0}) / (radius * radius);
      CHECK(light == Approx(wide.emplace(away, light).first->second).epsilon(0.05));
    }
  }
}

TEST_CASE("a last surface that bulges towards the scene may have its rim near the film") {
  // The same lens with a stop behind it that stops nothing: pupils are bounded elsewhere.
  const std::vector<LensSurface> lens{{12, 10, 1.9, 11}, {14, 2.5, 1, 6}};
  std::vector<LensSurface> stopped = lens;
  stopped[1].thickness = 1.5;
  stopped.push_back({0, 1, 1, 100});
  for (const float away : {0.0f, 0.7f, 1.4f})
    CHECK(mean_light(LensSystem(lens, 1.5), {away, 0}) ==
          Approx(mean_light(LensSystem(stopped, 1.5), {away, 0})).epsilon(0.01));
}

TEST_CASE("directions out of a lens are unit vectors into the scene, from its first surface") {
  const LensSystem lens(focused(double_gauss(), 1000), 21.6);
  double length_to_front = 0;
  for (const LensSurface& surface : lens.surfaces()) length_to_front += surface.thickness;
  int through = 0;
  for_each_sight(lens, {-10, 0}, [&](const LensSystem::Sight& sight) {
    if (sight.light == 0) return;
    ++through;
    if (std::fabs(length(sight.direction) - 1) > 1e-6f || !(sight.direction.z > 0) ||
        !(double(sight.origin.z) < length_to_front + 1e-4) || !(double(sight.origin.z) > length_to_front - 5))
      FAIL_CHECK("a ray from elsewhere, or to elsewhere");
  });
  CHECK(through > draws * draws / 4);
}

TEST_CASE("a lens that cannot be is refused with what is wrong with it") {
  const auto text = [](std::vector<LensSurface> surfaces, double film_radius = 20) {
    return error_text([&] { LensSystem(std::move(surfaces), film_radius); });
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(text({}), "1 to 1000 surfaces"));
  CHECK(contains(text(std::vector<LensSurface>(1001, {50, 1, 1.5, 5})), "this one 1001"));
  CHECK(contains(text({{nan, 5, 1.5, 5}, {-50, 50, 1, 5}}),
                 "surface 1 of the lens: a curvature radius of nan"));
  CHECK(contains(text({{50, 5, 1.5, 5}, {-50, -1, 1, 5}}), "surface 2 of the lens: a thickness of -1"));
  CHECK(contains(text({{50, 5, 0.5, 5}, {-50, 50, 1, 5}}), "index of refraction of 0.5; valid is 1 to 10"));
  CHECK(contains(text({{50, 5, 1.5, 0}, {-50, 50, 1, 5}}), "an aperture of 0"));
  CHECK(contains(text({{50, 5, 1.5, 5}, {-50, 50, 1.3, 5}}), "that of air, 1, before the film"));
  CHECK(contains(text({{-50, 5, 1.5, 5}, {50, 50, 1, 5}}), "brings no distant light together"));
  CHECK(
      contains(text({{1e200, 5, 1.5, 5}, {-50, 50, 1, 5}}), "a curvature radius of 1e+200; valid is 0, or"));
  CHECK(contains(text({{50, 5, 1.5, 1e200}, {-50, 50, 1, 5}}),
                 "an aperture of 1e+200; valid is 1e-30 to 1e30"));
  CHECK(
      contains(text({{20, 5, 1.5, 20}, {30, 25, 1, 29.9}}), "the rim of the last surface reaches the film"));
  CHECK(contains(text({{0, 5, 1, 5}}), "brings no distant light together"));
  CHECK(contains(text({{50, 5, 1.5, 5}, {-50, 0, 1, 5}}), "the film touches the lens"));
  CHECK(contains(text(single_lens(50, -50, 5), 0),
                 "a film that reaches 0 from the axis; valid is 1e-30 to 1e30"));
  CHECK(contains(text(single_lens(50, -50, 5), nan), "a film that reaches nan"));
}

TEST_CASE("a distance at which a lens makes nothing sharp is refused with the least one") {
  // Thin, with a focal length of 50: the film and what is sharp are at least four of them apart.
  const std::vector<LensSurface> lens = single_lens(50, -50, 1e-6);
  CHECK(contains(error_text([&] { focused(lens, 199.9); }), "nearer than 200"));
  CHECK(focused(lens, 200.1).back().thickness == Approx(100).epsilon(0.05));
  CHECK(focused(lens, 1e9).back().thickness == Approx(50));
}

TEST_CASE("a lens focused beyond what is infinitely far is sharp nowhere") {
  CHECK(std::isinf(LensSystem({{50, 1, 1.5, 5}, {-50, 40, 1, 5}}, 20).focus_distance()));
}

TEST_CASE("numbers of any size give light that is a number and not negative") {
  for (const double size : {1e-26, 1e-3, 1e3, 1e26}) {
    const LensSystem lens({{50 * size, 5 * size, 1.5, 5 * size}, {-50 * size, 50 * size, 1, 5 * size}},
                          20 * size);
    for (const float film : {0.0f, float(10 * size), std::numeric_limits<float>::infinity()}) {
      const float light = lens.sight({film, 0}, {0.5f, 0.5f}).light;
      CHECK(light >= 0);
      CHECK(std::isfinite(light));
    }
  }
}

}  // namespace twinray::test
