// SPDX-License-Identifier: Apache-2.0
#include "check/difference.h"

#include <limits>

#include "tests/support/catch.h"
#include "tests/support/film.h"

namespace twinray::test {
namespace {

constexpr int film_width = 4, film_height = 3;

Film film_of(PixelRect window) {
  Film film(film_width, film_height, window);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (std::uint32_t index = 0; index < 3; ++index) film.add(x, y, index, {float(x + 1), float(y), 0.5f});
  return film;
}

const PixelRect whole{0, 0, film_width, film_height};

std::string difference_after(int x, int y, const Rgb& expected, const Rgb& found) {
  Film a = film_of(whole), b = film_of(whole);
  a.add(x, y, 3, expected);
  b.add(x, y, 3, found);
  return first_difference(a, b).value_or("none");
}

}  // namespace

TEST_CASE("films of the same samples do not differ, whole or in part") {
  CHECK_FALSE(first_difference(film_of(whole), film_of(whole)));
  CHECK_FALSE(first_difference(film_of(whole), film_of({1, 1, 3, 2})));
}

TEST_CASE("one last bit of one sample is found, with its pixel, its channel and both sums") {
  const float next = std::nextafter(1.0f, 2.0f);
  CHECK(difference_after(2, 1, {1, 1, 1}, {next, 1, 1}) == "pixel 2 1: red 0x1.4p+3 and 0x1.4000004p+3");
  CHECK(difference_after(3, 2, {1, 1, 1}, {1, next, 1}) == "pixel 3 2: green 0x1.cp+2 and 0x1.c000008p+2");
  CHECK(difference_after(0, 0, {1, 1, 1}, {1, 1, next}) == "pixel 0 0: blue 0x1.4p+1 and 0x1.400001p+1");
}

TEST_CASE("a difference beyond the bits of a double is found") {
  // Near 2^20 a double ends at 2^-33; the sums hold 2^-43.
  Film a = film_of(whole), b = film_of(whole);
  for (Film* film : {&a, &b}) film->add(1, 0, 3, {0x1p20f, 0, 0});
  a.add(1, 0, 4, {0x1p-40f, 0, 0});
  b.add(1, 0, 4, {0x1p-41f, 0, 0});
  CHECK(first_difference(a, b) == "pixel 1 0: red 0x1.00006p+20, but for bits beyond a double's");
}

TEST_CASE("the same sums of other samples are found by their squares, their number or a rejection") {
  Film a = film_of(whole), b = film_of(whole);
  for (const float value : {1.0f, 3.0f}) a.add(1, 1, value > 2, {value, value, value});
  for (const float value : {2.0f, 2.0f}) b.add(1, 1, 3, {value, value, value});
  CHECK(first_difference(a, b).value_or("").find("pixel 1 1: luminance squared ") == 0);
  Film c = film_of(whole);
  c.add(0, 0, 3, {0, 0, 0});
  CHECK(first_difference(film_of(whole), c) == "pixel 0 0: samples 3 and 4");
  Film d = film_of(whole);
  d.add(3, 0, 3, {std::numeric_limits<float>::quiet_NaN(), 0, 0});
  CHECK(first_difference(film_of(whole), d) == "pixel 3 0: rejected samples 0 and 1");
  Film e = film_of(whole);
  e.add(3, 0, 4, {std::numeric_limits<float>::quiet_NaN(), 0, 0});
  CHECK(first_difference(d, e) == "pixel 3 0: first rejected samples 3 and 4");
}

TEST_CASE("the first of several differences is the one nearest to the top left") {
  Film a = film_of(whole), b = film_of(whole);
  for (const int x : {1, 3}) b.add(x, 1, 3, {1, 1, 1});
  b.add(0, 2, 3, {1, 1, 1});
  CHECK(first_difference(a, b) == "pixel 1 1: samples 3 and 4");
}

TEST_CASE("a difference in a layer is found where the colours do not differ") {
  const FilmContents layers{{Layer::albedo, Layer::depth}, {}};
  Film a(film_width, film_height, whole, layers), b(film_width, film_height, whole, layers);
  add_sample(a, 2, 1, 0, {{1, 1, 1}, {{0.5f, 0, 1}, {3, 0, 0}}});
  add_sample(b, 2, 1, 0, {{1, 1, 1}, {{0.5f, 0, 1}, {3.5f, 0, 0}}});
  CHECK_FALSE(first_difference(a, a));
  CHECK(first_difference(a, b) == "pixel 2 1: depth 0x1.8p+1 0x0p+0 0x0p+0 and 0x1.cp+1 0x0p+0 0x0p+0");
}

TEST_CASE("a difference in mattes, or in the parts of the light, is found as well") {
  const FilmContents contents{{Layer::object_matte}, {0, 2}};
  Film a(film_width, film_height, whole, contents), b = a, c = a;
  add_sample(a, 3, 1, 0, {{1, 1, 1}, {record_id(5)}, {}, {{1, 1, 1}, {0, 0, 0}}});
  add_sample(b, 3, 1, 0, {{1, 1, 1}, {record_id(6)}, {}, {{1, 1, 1}, {0, 0, 0}}});
  add_sample(c, 3, 1, 0, {{1, 1, 1}, {record_id(5)}, {}, {{1, 0.5f, 1}, {0, 0.5f, 0}}});
  CHECK(first_difference(a, b) == "pixel 3 1: cryptomatte-object");
  CHECK(first_difference(a, c) == "pixel 3 1: light by groups");
}

TEST_CASE("films of other frames, or with more pixels than expected, differ") {
  const std::string misfit = "frames, windows or layers that do not fit";
  CHECK(first_difference(film_of(whole), Film(film_width, film_height + 1, whole)) == misfit);
  CHECK(first_difference(film_of({1, 1, 3, 2}), film_of(whole)) == misfit);
  CHECK(first_difference(film_of(whole), Film(film_width, film_height, whole, {{Layer::depth}})) == misfit);
}

TEST_CASE("one ray more of any kind is a difference") {
  const RayCounts counts{.camera = 1, .shadow = 2, .bounce = 3};
  CHECK_FALSE(first_difference(counts, counts));
  CHECK(first_difference(counts, {.camera = 2, .shadow = 2, .bounce = 3}) == "camera rays 1 and 2");
  CHECK(first_difference(counts, {.camera = 1, .shadow = 3, .bounce = 3}) == "shadow rays 2 and 3");
  CHECK(first_difference(counts, {.camera = 1, .shadow = 2, .bounce = 4}) == "bounce rays 3 and 4");
}

}  // namespace twinray::test
