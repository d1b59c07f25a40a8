// SPDX-License-Identifier: Apache-2.0
#include "core/film.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/film.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

FixedSum sum_of(std::initializer_list<double> values) {
  FixedSum sum;
  for (const double value : values) sum.add(value);
  return sum;
}

struct Sample {
  int x, y;
  std::uint32_t index;
  Rgb value;
};

/// Samples of every size and sign, a few of them not acceptable.
std::vector<Sample> random_samples(int width, int height, std::uint32_t count) {
  test::Random random(23);
  const auto component = [&] {
    const float mantissa = random.uniform(-1, 1);
    return std::ldexp(mantissa, random.between(-40, 29));
  };
  std::vector<Sample> samples;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::uint32_t index = 0; index < count; ++index) {
        const float r = component();
        const float g = component();
        const float b = random.below(50) == 0 ? not_a_number : component();
        samples.push_back({x, y, index, {r, g, b}});
      }
  return samples;
}

void add(Film& film, const Sample& sample) { film.add(sample.x, sample.y, sample.index, sample.value); }

void check_equal(const Film& a, const Film& b) {
  for (int y = a.window().y0; y < a.window().y1; ++y)
    for (int x = a.window().x0; x < a.window().x1; ++x) {
      CAPTURE(x, y);
      CHECK(a.pixel(x, y) == b.pixel(x, y));
    }
  CHECK(a.rejected_count() == b.rejected_count());
  CHECK(a.first_rejected().x == b.first_rejected().x);
  CHECK(a.first_rejected().y == b.first_rejected().y);
  CHECK(a.first_rejected().index == b.first_rejected().index);
}

}  // namespace

TEST_CASE("each pixel lies in one line of a cache, which may be asked for before it is read") {
  const Film film(5, 3, {-1, 0, 5, 3});
  for (int y = 0; y < 3; ++y)
    for (int x = -1; x < 5; ++x) {
      film.prefetch(x, y);
      CHECK(reinterpret_cast<std::uintptr_t>(&film.pixel(x, y)) % 64 == 0);
    }
}

TEST_CASE("a pixel takes 64 bytes for colour, variance, count and rejections") {
  CHECK(sizeof(PixelSums) <= 64);
  CHECK(Film::bytes(640 * 480) == 640 * 480 * sizeof(PixelSums));
}

TEST_CASE("radiance up to 10^9 is taken, by readers and film alike") {
  CHECK(max_radiance == 1e9f);
  CHECK(Film::max_value == max_radiance);
}

TEST_CASE("a fixed sum is exact for numbers that its unit divides") {
  CHECK(sum_of({}).value() == 0);
  CHECK(sum_of({1.5, -0.25, 1024}).value() == 1025.25);
  CHECK(sum_of({1e9, 0x1p-43, -1e9}).value() == 0x1p-43);
  CHECK(sum_of({-1e9, -0x1p-43, 1e9}).value() == -0x1p-43);
  CHECK(sum_of({-3.75}).value() == -3.75);
  CHECK(sum_of({0.0, -0.0}) == FixedSum());
}

TEST_CASE("a fixed sum rounds each number to the nearest unit") {
  for (const double sign : {1.0, -1.0}) {
    CHECK(sum_of({sign * 0x1.8p-42}).value() == sign * 0x1.8p-42);
    CHECK(sum_of({sign * 0x1.9p-43}).value() == sign * 0x1p-42);
    CHECK(sum_of({sign * 0x1.1p-43}).value() == sign * 0x1p-43);
    CHECK(sum_of({sign * 0x1.1p-44}).value() == sign * 0x1p-43);
    CHECK(sum_of({sign * 0x0.fp-44}).value() == 0);
    CHECK(sum_of({sign * 5e-324, sign * 1e-300}).value() == 0);
    CHECK(sum_of({sign * double(0x1.dcd64ep29f)}).value() == sign * double(0x1.dcd64ep29f));
  }
}

TEST_CASE("words carry and borrow into each other") {
  // Units of 2^-43: the words begin at 2^-43, 2^-11 and 2^21.
  for (const double boundary : {0x1p-11, 0x1p21}) {
    CHECK(sum_of({boundary - 0x1p-43, 0x1p-43}).value() == boundary);
    CHECK(sum_of({boundary, -0x1p-43}).value() == boundary - 0x1p-43);
    CHECK(sum_of({-boundary, 0x1p-43}).value() == -boundary + 0x1p-43);
    CHECK(sum_of({0x1p-43, -boundary, boundary}).value() == 0x1p-43);
  }
}

TEST_CASE("a fixed sum of the largest numbers does not overflow") {
  for (const double sign : {1.0, -1.0}) {
    FixedSum sum = sum_of({sign * 1e9});
    for (int doubling = 0; doubling < 22; ++doubling) sum += FixedSum(sum);
    CHECK(sum.value() == sign * 1e9 * 0x1p22);
  }
}

TEST_CASE("a sum of squares keeps the largest and the smallest, and rounds up what is smaller still") {
  FixedSquareSum largest;
  largest.add_square_of(-1e9);
  FixedSquareSum with_smallest = largest;
  with_smallest.add_square_of(0x1p-23);
  CHECK_FALSE(with_smallest == largest);
  for (int doubling = 0; doubling < 22; ++doubling) largest += FixedSquareSum(largest);
  CHECK(largest.value() == 1e18 * 0x1p22);
  const auto square_of = [](double x) {
    FixedSquareSum sum;
    sum.add_square_of(x);
    return sum.value();
  };
  CHECK(square_of(0) == 0);
  CHECK(square_of(0.5) == 0.25);
  CHECK(square_of(0x1p-23) == 0x1p-46);
  CHECK(square_of(0x1.1p-23) == 0x1p-45);
  CHECK(square_of(1e-30) == 0x1p-46);
}

TEST_CASE("a fixed sum has no order") {
  test::Random random(5);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i) {
    const double mantissa = random.uniform(-1, 1) + random.unit() * 0x1p-25;
    values.push_back(std::ldexp(mantissa, random.between(-50, 28)));
  }
  FixedSum forward, backward, halves, rest;
  for (const double value : values) forward.add(value);
  for (std::size_t i = values.size(); i-- > 0;) backward.add(values[i]);
  for (std::size_t i = 0; i < values.size(); ++i) (i % 3 == 0 ? halves : rest).add(values[i]);
  halves += rest;
  CHECK(forward == backward);
  CHECK(forward == halves);
}

TEST_CASE("mean and variance agree with a two-pass computation") {
  constexpr int count = 1000;
  test::Random random(9);
  Film film(1, 1, {0, 0, 1, 1});
  std::vector<double> luminances;
  double r_sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float r = random.unit(), g = random.unit() * 3, b = random.unit() * 10;
    film.add(0, 0, i, {r, g, b});
    luminances.push_back(0.2126 * r + 0.7152 * g + 0.0722 * b);
    r_sum += r;
  }
  double mean = 0, variance = 0;
  for (const double l : luminances) mean += l / count;
  for (const double l : luminances) variance += (l - mean) * (l - mean) / (count - 1);
  const PixelSums& pixel = film.pixel(0, 0);
  constexpr double tolerance = 1e-12;  // Rounding of a few sums of 1000 doubles.
  CHECK(pixel.count == count);
  CHECK(pixel.mean().r == float(r_sum / count));
  CHECK(pixel.luminance_mean() == Approx(mean).epsilon(tolerance));
  CHECK(pixel.luminance_variance() == Approx(variance).epsilon(tolerance));
}

TEST_CASE("the variance of a constant is nothing but rounding, and never negative") {
  test::Random random(31);
  for (int trial = 0; trial < 1000; ++trial) {
    const Rgb value = {random.unit(), random.unit(), random.unit()};
    Film film(1, 1, {0, 0, 1, 1});
    for (std::uint32_t i = 0; i < 50; ++i) film.add(0, 0, i, value);
    REQUIRE(film.pixel(0, 0).luminance_variance() >= 0);
    REQUIRE(film.pixel(0, 0).luminance_variance() < 0x1.1p-46);  // The unit, rounded up 50 times.
  }
}

TEST_CASE("a pixel without samples is black, and one sample has no variance") {
  Film film(2, 1, {0, 0, 2, 1});
  CHECK(film.pixel(0, 0).mean() == Rgb{});
  CHECK(film.pixel(0, 0).luminance_mean() == 0);
  CHECK(film.pixel(0, 0).luminance_variance() == 0);
  CHECK(film.add(1, 0, 0, {1, 2, 3}));
  CHECK(film.pixel(1, 0).mean() == Rgb{1, 2, 3});
  CHECK(film.pixel(1, 0).luminance_variance() == 0);
}

TEST_CASE("as many of the largest samples as a pixel may have do not overflow, and one more is refused") {
  for (const float value : {Film::max_value, -Film::max_value}) {
    Film film(1, 1, {0, 0, 1, 1});
    CHECK(film.add(0, 0, 0, {value, value, value}));
    for (int doubling = 0; doubling < 22; ++doubling) film.merge(Film(film));
    const PixelSums full = film.pixel(0, 0);
    CHECK(full.count == Film::max_samples);
    CHECK(full.mean() == Rgb{value, value, value});
    CHECK(full.luminance_mean() == Approx(value));
    CHECK(full.luminance_variance() >= 0);
    CHECK_THROWS_WITH(film.merge(Film(film)), "merged, pixel (0, 0) has more than 4194304 samples");
    CHECK(film.pixel(0, 0) == full);
  }
}

TEST_CASE("any order and partition of the samples merges to the same bits") {
  const std::vector<Sample> samples = random_samples(7, 5, 40);
  Film whole(20, 10, {0, 0, 7, 5}), reversed = whole, merged = whole;
  for (const Sample& sample : samples) add(whole, sample);
  for (std::size_t i = samples.size(); i-- > 0;) add(reversed, samples[i]);
  Film left(20, 10, {0, 0, 3, 5}), right(20, 10, {3, 0, 7, 5}), even = right;
  for (const Sample& sample : samples)
    add(sample.x < 3 ? left : sample.index % 2 == 0 ? even : right, sample);
  merged.merge(right);
  merged.merge(left);
  merged.merge(even);
  CHECK(whole.rejected_count() > 0);
  check_equal(whole, reversed);
  check_equal(whole, merged);
}

TEST_CASE("threads may add to different pixels at the same time") {
  const std::vector<Sample> samples = random_samples(8, 8, 200);
  Film one(8, 8, {0, 0, 8, 8}), several = one;
  for (const Sample& sample : samples) add(one, sample);
  std::vector<std::thread> threads;
  for (int part = 0; part < 4; ++part)
    threads.emplace_back([&, part] {
      for (const Sample& sample : samples)
        if ((sample.x + sample.y) % 4 == part) add(several, sample);
    });
  for (std::thread& thread : threads) thread.join();
  check_equal(one, several);
}

TEST_CASE("samples that are not finite or out of range are counted and nothing else") {
  Film film(10, 10, {2, 3, 8, 9});
  const float beyond = std::nextafter(Film::max_value, unbounded);
  CHECK(film.rejected_count() == 0);
  CHECK_FALSE(film.add(5, 6, 9, {not_a_number, 0, 0}));
  CHECK_FALSE(film.add(5, 6, 4, {0, unbounded, 0}));
  CHECK_FALSE(film.add(5, 6, 7, {0, 0, -unbounded}));
  CHECK_FALSE(film.add(2, 7, 0, {beyond, 0, 0}));
  CHECK_FALSE(film.add(7, 6, 1, {0, -beyond, 0}));
  CHECK(film.add(5, 6, 5, {Film::max_value, -Film::max_value, 0}));
  CHECK(film.rejected_count() == 5);
  CHECK(film.pixel(5, 6).rejected == 3);
  CHECK(film.pixel(5, 6).rejected_index == 4);
  CHECK(film.pixel(4, 6).rejected == 0);
  CHECK(film.pixel(5, 6).count == 1);
  CHECK(film.pixel(2, 7).count == 0);
}

TEST_CASE("the first rejected sample is the least of (y, x, index), in whatever order they came") {
  const std::vector<Sample> samples = {{5, 6, 9, {}}, {5, 6, 4, {}}, {2, 7, 0, {}}, {7, 6, 1, {}}};
  Film forward(10, 10, {2, 3, 8, 9}), backward = forward, merged = forward;
  const Rgb bad = {not_a_number, 0, 0};
  for (const Sample& s : samples) forward.add(s.x, s.y, s.index, bad);
  for (std::size_t i = samples.size(); i-- > 0;)
    backward.add(samples[i].x, samples[i].y, samples[i].index, bad);
  merged.merge(backward);
  for (const Film* film : {&forward, &backward, &merged}) {
    const RejectedSample first = film->first_rejected();
    CHECK(first.x == 5);
    CHECK(first.y == 6);
    CHECK(first.index == 4);
  }
}

TEST_CASE("a layer takes at most 8 bytes a channel and pixel") {
  for (const Layer layer : all_layers()) {
    CAPTURE(layer_info(layer).name);
    CHECK(Film::bytes(10, {{layer}}) <= 10 * (sizeof(PixelSums) + 8 * channel_count(layer)));
  }
  CHECK(Film::bytes(10, {{Layer::albedo, Layer::depth}, {8, 2}}) ==
        10 * (sizeof(PixelSums) + 24 + 8 + 8 * 24 + 2 * 24));
}

TEST_CASE("a film keeps of each layer what its samples say, and what its colours say") {
  Film film(4, 3, {1, 1, 4, 3}, {{Layer::albedo, Layer::depth, Layer::samples, Layer::variance}});
  const std::vector<Rgb> first{{0.5f, 0, 1}, {not_a_number, 0, 0}, {}, {}};
  const std::vector<Rgb> second{{0, 0, 0.5f}, {7, 0, 0}, {}, {}};
  const std::vector<Rgb> third{{1, 0, 0}, {3, 0, 0}, {}, {}};
  test::add_sample(film, 2, 1, 2, {{3, 3, 3}, third});
  test::add_sample(film, 2, 1, 0, {{1, 1, 1}, first});
  test::add_sample(film, 2, 1, 1, {{2, 2, 2}, second});
  CHECK(film.pixel(2, 1).count == 3);
  CHECK(film.value(0, 2, 1) == Rgb{0.5f, 0, 0.5f});
  CHECK(film.value(1, 2, 1) == Rgb{7, 0, 0});
  CHECK(film.value(2, 2, 1).r == 3);
  CHECK(film.value(3, 2, 1).r == Approx(1.0 / 3));
  CHECK(film.value(0, 3, 1) == Rgb{});
  CHECK(film.value(1, 3, 1).r == 1e10f);
  CHECK(film.value(3, 3, 1).r == 0);
}

TEST_CASE("any order and partition of the samples gives a layer the same values") {
  const FilmContents layers{{Layer::normal, Layer::position}, {2, 0}};
  const std::vector<Sample> samples = random_samples(5, 4, 30);
  Film whole(5, 4, {0, 0, 5, 4}, layers), reversed = whole, merged = whole;
  Film left(5, 4, {0, 0, 2, 4}, layers), right(5, 4, {2, 0, 5, 4}, layers);
  const auto add_with_layers = [](Film& film, const Sample& sample) {
    const Rgb value{sample.value.r, sample.value.g, 0};
    test::add_sample(film, sample.x, sample.y, sample.index, {{1, 1, 1}, {value, value}, {value, value}});
  };
  for (const Sample& sample : samples) add_with_layers(whole, sample);
  for (std::size_t i = samples.size(); i-- > 0;) add_with_layers(reversed, samples[i]);
  for (const Sample& sample : samples) add_with_layers(sample.x < 2 ? left : right, sample);
  merged.merge(right);
  merged.merge(left);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      for (const std::size_t layer : {0, 1}) {
        const Rgb expected = whole.value(layer, x, y);
        CHECK(reversed.value(layer, x, y) == expected);
        CHECK(merged.value(layer, x, y) == expected);
      }
  for (const Film* const film : {&reversed, &merged}) {
    Rgb expected[2], parts[2];
    whole.read_parts(Division::paths, 3, 2, expected);
    film->read_parts(Division::paths, 3, 2, parts);
    CHECK(std::equal(parts, parts + 2, expected));
  }
}

TEST_CASE("the parts of the colours add up to them, whatever the order") {
  Film film(1, 1, {0, 0, 1, 1}, {{}, {light_path_count, 3}});
  test::Random random(6);
  for (std::uint32_t index = 0; index < 1000; ++index) {
    std::vector<Rgb> parts(light_path_count);
    Rgb color;
    for (Rgb& part : parts) {
      const float r = random.unit(), g = random.unit() * 1e6f;
      part = {r, g, random.below(2) == 0 ? 0 : r * 1e-9f};
      color += part;
    }
    test::add_sample(film, 0, 0, index, {color, {}, parts, {color * 0.25f, color * 0.5f, color * 0.25f}});
  }
  const Rgb mean = film.pixel(0, 0).mean();
  for (const Division division : divisions) {
    std::vector<Rgb> parts(film.contents().parts[std::size_t(division)]);
    film.read_parts(division, 0, 0, parts);
    Rgb forward, backward;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      forward += parts[i];
      backward += parts[parts.size() - 1 - i];
    }
    CHECK(forward == mean);
    CHECK(backward == mean);
  }
  std::vector<Rgb> groups(3);
  film.read_parts(Division::groups, 0, 0, groups);
  CHECK(groups[1].g == Approx(mean.g / 2));
}

TEST_CASE("films of other layers are not merged") {
  Film film(2, 2, {0, 0, 2, 2}, {{Layer::albedo}});
  CHECK_THROWS_WITH(film.merge(Film(2, 2, {0, 0, 2, 2}, {{Layer::normal, Layer::depth}})),
                    "films of different layers cannot be merged: color, albedo and color, normal, depth");
  CHECK_THROWS_WITH(film.merge(Film(2, 2, {0, 0, 2, 2}, {{Layer::albedo}, {8, 3}})),
                    "films of different layers cannot be merged: color, albedo and color, albedo, light by 8 "
                    "paths, light by 3 groups");
}

TEST_CASE("a sample whose radiance is rejected counts in no layer") {
  Film film(1, 1, {0, 0, 1, 1}, {{Layer::albedo, Layer::depth}});
  const std::vector<Rgb> values{{1, 1, 1}, {5, 0, 0}};
  CHECK_FALSE(test::add_sample(film, 0, 0, 0, {{not_a_number, 0, 0}, values}));
  CHECK(film.value(0, 0, 0) == Rgb{});
  CHECK(film.value(1, 0, 0).r == 1e10f);
  CHECK(test::add_sample(film, 0, 0, 1, {{1, 1, 1}, values}));
  CHECK(film.value(0, 0, 0) == Rgb{1, 1, 1});
  CHECK(film.value(1, 0, 0).r == 5);
}

TEST_CASE("the least index of rejected samples is kept when films are merged, in either order") {
  Film early(1, 1, {0, 0, 1, 1}), late = early, none = early;
  const Rgb bad = {not_a_number, 0, 0};
  early.add(0, 0, 2, bad);
  late.add(0, 0, 9, bad);
  none.add(0, 0, 0, {1, 1, 1});
  const auto merged = [](Film to, const Film& from) {
    to.merge(from);
    return to.pixel(0, 0);
  };
  CHECK(merged(early, late).rejected_index == 2);
  CHECK(merged(late, early).rejected_index == 2);
  CHECK(merged(late, early).rejected == 2);
  CHECK(merged(late, none).rejected_index == 9);
  CHECK(merged(none, late).rejected_index == 9);
  CHECK(merged(none, none).rejected == 0);
}

TEST_CASE("rejected samples count towards the most that a pixel may have") {
  Film film(1, 1, {0, 0, 1, 1});
  film.add(0, 0, 0, {1, 1, 1});
  film.add(0, 0, 1, {not_a_number, 0, 0});
  for (int doubling = 0; doubling < 21; ++doubling) film.merge(Film(film));
  CHECK(film.pixel(0, 0).count == Film::max_samples / 2);
  Film one(1, 1, {0, 0, 1, 1});
  one.add(0, 0, 0, {1, 1, 1});
  CHECK_THROWS_WITH(film.merge(one), "merged, pixel (0, 0) has more than 4194304 samples");
}

TEST_CASE("a film that does not fit is not merged") {
  Film film(8, 6, {1, 1, 5, 5});
  CHECK_THROWS_WITH(film.merge(Film(8, 7, {1, 1, 5, 5})),
                    "films of different frames cannot be merged: 8 x 6 and 8 x 7 pixels");
  CHECK_THROWS_WITH(film.merge(Film(8, 6, {1, 1, 6, 5})),
                    "the window x 1 to 6, y 1 to 5 cannot be merged into the smaller x 1 to 5, y 1 to 5");
}

TEST_CASE("frames and windows out of range are refused") {
  CHECK_THROWS_WITH(Film(0, 5, {0, 0, 1, 1}), "a frame of 0 x 5 pixels: each side must lie in 1 to 65536");
  CHECK_THROWS_AS(Film(5, 65537, {0, 0, 1, 1}), Error);
  CHECK_THROWS_WITH(
      Film(8, 6, {2, 0, 2, 6}),
      "the window x 2 to 2, y 0 to 6 is empty, or reaches more than 65536 pixels beyond the frame of 8 x 6");
  for (const PixelRect& window :
       {PixelRect{-65537, 0, 4, 4}, PixelRect{0, -65537, 4, 4}, PixelRect{0, 0, 65545, 4},
        PixelRect{0, 0, 4, 65543}, PixelRect{0, 3, 4, 3}, PixelRect{3, 0, 2, 4}})
    CHECK_THROWS_AS(Film(8, 6, window), Error);
  Film around(8, 6, {-2, -1, 9, 8});
  CHECK(around.add(-2, -1, 0, {1, 2, 3}));
  CHECK(around.pixel(-2, -1).mean() == Rgb{1, 2, 3});
  CHECK(around.pixel(8, 7).count == 0);
}

}  // namespace twinray
