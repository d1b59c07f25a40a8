// SPDX-License-Identifier: Apache-2.0
#include "core/pixel_filter.h"

#include <cmath>

#include "core/error.h"
#include "core/filter_sampler.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"

namespace twinray::test {
namespace {

constexpr FilterKind all_kinds[] = {FilterKind::box, FilterKind::triangle, FilterKind::gaussian,
                                    FilterKind::blackman_harris, FilterKind::mitchell};

/// The integral of filter times f along one axis, over that of the filter: by the midpoint rule.
template <typename F>
double filtered(const PixelFilter& filter, double radius, const F& f) {
  constexpr int steps = 200000;
  double sum = 0, all = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = radius * ((2 * i + 1.0) / steps - 1), value = filter_value(filter, radius, x);
    sum += value * f(x);
    all += value;
  }
  return sum / all;
}

/// The mean of weight times f(distance from the middle along x) over equally spaced places.
template <typename F>
double sampled(const FilterSampler& sampler, const F& f) {
  constexpr int steps = 1 << 17;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const FilterSampler::Place place = sampler.place({(float(i) + 0.5f) / steps, 0.5f});
    sum += double(place.weight) * f(double(place.in_pixel.x) - 0.5);
  }
  return sum / steps;
}

/// The weight along y alone, at the middle of the pixel.
double weight_across(const FilterSampler& sampler) {
  return sampled(sampler, [](double) { return 1.0; });
}

std::string message_of(const PixelFilter& filter) {
  try {
    check(filter);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("filters have their well-known values") {
  const auto value = [](FilterKind kind, double x) {
    const PixelFilter filter = usual_filter(kind);
    return filter_value(filter, double(filter.radius.x), x);
  };
  CHECK(value(FilterKind::box, 0.49) == 1);
  CHECK(value(FilterKind::box, 0.51) == 0);
  CHECK(value(FilterKind::triangle, -0.25) == Approx(0.75));
  const double edge = std::exp(-4.5);
  CHECK(value(FilterKind::gaussian, 0) == Approx(1 - edge));
  CHECK(value(FilterKind::gaussian, -0.5) == Approx(std::exp(-0.5) - edge));
  CHECK(value(FilterKind::blackman_harris, 0) == Approx(1));
  CHECK(value(FilterKind::blackman_harris, 0.75) == Approx(0.35875 - 0.14128));
  CHECK(value(FilterKind::blackman_harris, 1.5) == Approx(6e-5).epsilon(1e-3));
  CHECK(value(FilterKind::mitchell, 0) == Approx(8.0 / 9));
  CHECK(value(FilterKind::mitchell, 1) == Approx(1.0 / 18));
  CHECK(value(FilterKind::mitchell, -1.5) == Approx(-5.0 / 144));
  CHECK(value(FilterKind::mitchell, 2) == Approx(0).margin(1e-12));
  for (const FilterKind kind : all_kinds) CHECK(value(kind, 2.01) == 0);
}

TEST_CASE("samples of a filter have its moments, also where it is negative") {
  constexpr double tolerance = 2e-5;  // What a table of 512 steps keeps of a filter.
  const auto square = [](double x) { return x * x; };
  const auto wave = [](double x) { return std::cos(3 * x); };
  const auto edge = [](double x) { return x > 0.3 ? 1.0 : 0.0; };
  for (const FilterKind kind : all_kinds) {
    CAPTURE(filter_name(kind));
    PixelFilter filter = usual_filter(kind);
    filter.radius.y = 0.1f + filter.radius.x;  // Another one across.
    const FilterSampler sampler(filter);
    const double across = weight_across(sampler), radius = double(filter.radius.x);
    CHECK(sampled(sampler, square) / across == Approx(filtered(filter, radius, square)).margin(tolerance));
    CHECK(sampled(sampler, wave) / across == Approx(filtered(filter, radius, wave)).margin(tolerance));
    CHECK(sampled(sampler, edge) / across == Approx(filtered(filter, radius, edge)).margin(tolerance));
  }
}

TEST_CASE("the weights of a filter have the mean 1, and its sign") {
  for (const FilterKind kind : all_kinds) {
    CAPTURE(filter_name(kind));
    const PixelFilter filter = usual_filter(kind);
    const FilterSampler sampler(filter);
    // Along x the mean is 1; along y the middle has the integral of |f|, which is 1.07 for Mitchell's.
    const bool is_mitchell = kind == FilterKind::mitchell;
    CHECK(weight_across(sampler) == Approx(is_mitchell ? 1.0699708 : 1).epsilon(1e-4));
    constexpr int steps = 256;
    bool has_negative = false;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const auto [at, weight] = sampler.place({(float(i) + 0.5f) / steps, (float(j) + 0.5f) / steps});
        has_negative = has_negative || weight < 0;
        const double value = filter_value(filter, double(filter.radius.x), double(at.x) - 0.5) *
                             filter_value(filter, double(filter.radius.y), double(at.y) - 0.5);
        if (std::fabs(value) > 1e-6) REQUIRE((value < 0) == (weight < 0));
      }
    CHECK(has_negative == is_mitchell);
  }
}

TEST_CASE("places of a filter are spread by its density: equal numbers in parts of equal integral") {
  // Independent of the table: the integral up to a place, by the midpoint rule.
  for (const FilterKind kind : all_kinds) {
    CAPTURE(filter_name(kind));
    const PixelFilter filter = usual_filter(kind);
    const FilterSampler sampler(filter);
    const auto radius = double(filter.radius.x);
    constexpr int cells = 20000;
    std::vector<double> up_to{0};
    for (int i = 0; i < cells; ++i)
      up_to.push_back(up_to.back() +
                      std::fabs(filter_value(filter, radius, radius * ((2 * i + 1.0) / cells - 1))));
    for (int i = 1; i < 1000; ++i) {
      const double x = double(sampler.place({float(i) / 1000, 0.25f}).in_pixel.x) - 0.5;
      const double cell = (x / radius + 1) / 2 * cells;
      REQUIRE(cell >= 0);
      REQUIRE(cell <= cells);
      CHECK(up_to[std::size_t(cell)] / up_to.back() == Approx(i / 1000.0).margin(1e-3));
    }
  }
}

TEST_CASE("a box of the usual radius leaves draws as they are, and a wider one reaches beside the pixel") {
  const FilterSampler box(usual_filter(FilterKind::box));
  for (const float u : {0.0f, 0x1p-24f, 0.1f, 0.3f, 0.99999994f}) {
    CHECK(box.place({u, 0.7f}).in_pixel == Vec2{u, 0.7f});
    CHECK(box.place({u, 0.7f}).weight == 1);
  }
  const FilterSampler wide(filter_of_radius(FilterKind::box, 2));
  CHECK(wide.place({0, 0.5f}).in_pixel == Vec2{-1.5f, 0.5f});
  CHECK(wide.place({0.75f, 0.5f}).in_pixel == Vec2{1.5f, 0.5f});
}

TEST_CASE("the ends of the draws are the ends of a filter") {
  for (const FilterKind kind : all_kinds) {
    CAPTURE(filter_name(kind));
    const PixelFilter filter = usual_filter(kind);
    const FilterSampler sampler(filter);
    CHECK(sampler.place({0, 0}).in_pixel.x == Approx(0.5f - filter.radius.x));
    const Vec2 last = sampler.place({0.99999994f, 0.99999994f}).in_pixel;
    CHECK(last.x <= 0.5f + filter.radius.x);
    CHECK(last.y > 0.4f + 0.9f * filter.radius.y);
    if (kind != FilterKind::box) CHECK(sampler.place({0.5f, 0.5f}).in_pixel == Vec2{0.5f, 0.5f});
  }
}

TEST_CASE("filters out of range are refused, and have texts") {
  CHECK(message_of(filter_of_radius(FilterKind::box, 0.01f)) ==
        "a pixel filter's radius is 0.01; valid are 0.1 to 16");
  CHECK(message_of(filter_of_radius(FilterKind::box, NAN)) ==
        "a pixel filter's radius is nan; valid are 0.1 to 16");
  PixelFilter filter = usual_filter(FilterKind::mitchell);
  filter.c = 1.5f;
  CHECK(message_of(filter) == "a pixel filter's C is 1.5; valid are 0 to 1");
  CHECK_THROWS_AS(FilterSampler(filter), Error);
  CHECK(filter_text(usual_filter(FilterKind::blackman_harris)) == "blackman-harris:1.5");
  filter.radius = {1, 2.5f};
  CHECK(filter_text(filter) == "mitchell:1x2.5");
  CHECK(filter_of_radius(FilterKind::gaussian, 3).sigma == 1);
}

}  // namespace twinray::test
