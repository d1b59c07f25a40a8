// SPDX-License-Identifier: Apache-2.0
#include "core/environment.h"

#include <cmath>
#include <functional>

#include "core/radiance.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

constexpr MapLayout layouts[] = {MapLayout::latitude_longitude, MapLayout::equal_area};
constexpr double sphere = 4 * M_PI;
/// A direction is rounded to floats, and found again to a few of their last bits.
constexpr double rounding = 2e-6;

const char* name_of(MapLayout layout) {
  return layout == MapLayout::equal_area ? "equal area" : "latitude and longitude";
}

Image blank(MapLayout layout, int height) {
  return Image(layout == MapLayout::equal_area ? height : 2 * height, height);
}

/// Random colours, a fifth of the pixels black, a few thirty times as bright.
std::shared_ptr<const Image> random_map(MapLayout layout, int height, std::uint64_t seed = 3) {
  auto map = std::make_shared<Image>(blank(layout, height));
  Random random(seed);
  for (Rgb& pixel : map->pixels) {
    const float scale = random.below(5) == 0 ? 0 : random.below(10) == 0 ? 30 : 1;
    const float r = random.unit(), g = random.unit(), b = random.unit();
    pixel = Rgb{r, g, b} * scale;
  }
  return map;
}

/// A turn about a slanted axis, and a mirror.
Transform slanted_mirror() { return Transform::rotation({1, 2, -1}, 77) * Transform::scaling(-1, 1, 1); }

Vec3 any_direction(Random& random) { return normalize(random.in_ball()); }

double distance(const Vec3& a, const Vec3& b) { return std::sqrt(double(length_squared(a - b))); }

/// A direction from its point, by the smallest of cells.
Vec3 direction_of(MapLayout layout, MapPoint p) { return direction_within(layout, {p, p}, {0, 0}); }

/// Calls `check` with environments of all kinds and with numbers of draws or directions, below and above what
/// waits for memory together.
void for_batches(const std::function<void(const Environment&, std::size_t)>& check) {
  for (const MapLayout layout : layouts)
    for (const double compensation : {0.0, 1.0, 1e9}) {
      const Environment environment({random_map(layout, 32), layout, slanted_mirror(), {1, 2, 3}},
                                    compensation);
      for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 200u}) {
        CAPTURE(name_of(layout), compensation, count);
        check(environment, count);
      }
    }
}

}  // namespace

TEST_CASE("a direction's point of a map has that direction, in both layouts") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 direction = any_direction(random);
      worst = std::max(worst, distance(direction_of(layout, map_point(layout, direction)), direction));
    }
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, -1, 0},
                             Vec3{0, 0, -1}, Vec3{1e-20f, 0, 1}, Vec3{0, 1, -1e-20f}})
      worst = std::max(worst, distance(direction_of(layout, map_point(layout, axis)), axis));
    CHECK(worst < rounding);
  }
}

TEST_CASE("a point of a map has a direction of that point, in both layouts") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      // Columns run together at the poles of one of them.
      const double x = random.unit(), y = 0.01 + 0.98 * random.unit();
      const MapPoint back = map_point(layout, direction_of(layout, {x, y}));
      worst = std::max({worst, std::fabs(back.x - x), std::fabs(back.y - y)});
    }
    CHECK(worst < 1e-5);
  }
}

TEST_CASE("the equal-area square has +z in its middle, -z in its corners, x to the right, y downwards") {
  const auto is_near = [](MapPoint p, double x, double y) {
    return std::fabs(p.x - x) < 1e-12 && std::fabs(p.y - y) < 1e-12;
  };
  const auto at = [](const Vec3& d) { return map_point(MapLayout::equal_area, d); };
  CHECK(is_near(at({0, 0, 1}), 0.5, 0.5));
  CHECK(is_near(at({1, 0, 0}), 1, 0.5));
  CHECK(is_near(at({0, 1, 0}), 0.5, 1));
  CHECK(is_near(at({-1, 0, 0}), 0, 0.5));
  CHECK(is_near(at({0, -1, 0}), 0.5, 0));
  CHECK(is_near(at({0, 0, -1}), 1, 1));
  // r^2 = 1 - |z|: at 60 degrees from +z, r is the root of 1/2, on the diagonal shared by both.
  const double half = 0.25 / std::sqrt(2.0);
  const float s = float(std::sqrt(0.375));
  const MapPoint diagonal = at({s, -s, 0.5f});
  CHECK(diagonal.x == Approx(0.5 + half).epsilon(1e-6));
  CHECK(diagonal.y == Approx(0.5 - half).epsilon(1e-6));
}

TEST_CASE("cells of a map share the sphere among them, and each is sampled uniformly") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    double sum = 0;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 5; ++x)
        sum += solid_angle(layout, {{x / 5.0, y / 7.0}, {(x + 1) / 5.0, (y + 1) / 7.0}});
    CHECK(sum == Approx(sphere).epsilon(1e-12));
    // All of the map is a cell: every direction is as likely, by two independent coordinates.
    Random random(4);
    Grid grid(16, 12);
    for (int i = 0; i < 200000; ++i) {
      const Vec3 w = direction_within(layout, {{0, 0}, {1, 1}}, in_square(random));
      grid.add(std::atan2(double(w.x), double(w.y)) / (2 * M_PI) + 0.5, 0.5 + 0.5 * double(w.z));
    }
    check_uniform(grid.counts(), 2, 0.03);
  }
}

TEST_CASE("an equal-area map goes on over its edges as the sphere does") {
  const auto map = random_map(MapLayout::equal_area, 8);
  const Environment environment({map, MapLayout::equal_area}, 0);
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    // Two directions side by side, of two points on different parts of the edge.
    const float turn = 2 * float(M_PI) * random.unit(), r = 1 - random.unit() * random.unit();
    const Vec3 d{r * std::cos(turn), r * std::sin(turn), -std::sqrt(std::max(0.0f, 1 - r * r))};
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
      // Across the half-planes x = 0 and y = 0 below the horizon, where the square is cut.
      const Vec3 flat = normalize(d - axis * dot(d, axis));
      const Rgb one = environment.radiance(normalize(flat + axis * 1e-5f));
      const Rgb other = environment.radiance(normalize(flat - axis * 1e-5f));
      CHECK(max_component(one - other) < 0.05);
      CHECK(max_component(other - one) < 0.05);
    }
  }
}

TEST_CASE("an environment is turned, mirrored and scaled as it says") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    const auto map = random_map(layout, 6);
    const Transform rotation = slanted_mirror();
    const Environment plain({map, layout}, 0), moved({map, layout, rotation, {2, 3, 0.5f}}, 0);
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 direction = any_direction(random);
      const Rgb expected = plain.radiance(direction), seen = moved.radiance(rotation.vector(direction));
      // A colour changes by 30 within a sixtieth of the sphere.
      CHECK(seen.r == Approx(2 * expected.r).margin(1e-3));
      CHECK(seen.g == Approx(3 * expected.g).margin(1e-3));
      CHECK(seen.b == Approx(0.5 * expected.b).margin(1e-3));
    }
  }
  const auto bright = std::make_shared<Image>(1, 1);
  bright->pixels = {{9e8f, 1, 1}};
  CHECK(Environment({bright, {}, {}, {2, 2, 2}}, 0).radiance({0, 1, 0}) == Rgb{max_radiance, 2, 2});
}

TEST_CASE(
    "directions of an environment are chosen with the density that is stated, with and without "
    "compensation") {
  constexpr int samples = 300000, columns = 18, rows = 16, fine = 24;
  for (const MapLayout layout : layouts)
    for (const double compensation : {0.0, 0.5, 1.0}) {
      CAPTURE(name_of(layout), compensation);
      const Environment environment({random_map(layout, 6), layout, slanted_mirror()}, compensation);
      Random random(8);
      Grid grid(columns, rows);
      for (int i = 0; i < samples; ++i) {
        const Environment::Sample sample = environment.sample(in_square(random));
        REQUIRE(sample.pdf > 0);
        REQUIRE(sample.pdf == environment.pdf(sample.direction));
        REQUIRE(sample.radiance == environment.radiance(sample.direction));
        const Vec3& w = sample.direction;
        grid.add(std::atan2(double(w.x), double(w.y)) / (2 * M_PI) + 0.5, 0.5 + 0.5 * double(w.z));
      }
      // The integral of the density over each bin, by a fine grid of equal solid angles.
      std::vector<double> expected;
      double integral = 0;
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
          double sum = 0;
          for (int j = 0; j < fine; ++j)
            for (int i = 0; i < fine; ++i) {
              const double turn = (column + (i + 0.5) / fine) / columns - 0.5;
              const double z = 2 * ((row + (j + 0.5) / fine) / rows) - 1;
              const double r = std::sqrt(1 - z * z);
              sum += environment.pdf(
                  {float(r * std::sin(2 * M_PI * turn)), float(r * std::cos(2 * M_PI * turn)), float(z)});
            }
          const double probability = sum * sphere / (double(columns) * rows * fine * fine);
          integral += probability;
          expected.push_back(probability);
        }
      CHECK(integral == Approx(1).epsilon(0.002));
      // The grid may miss the tip of a cell in a bin: it is pooled with others, not impossible.
      for (double& count : expected) count = count * samples / integral + 1e-6;
      check_counts(grid.counts(), expected, 6, 0.03);
    }
}

TEST_CASE("the mean of radiance over density is the light of the whole map") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    const Environment environment({random_map(layout, 6), layout}, 0);
    Random random(9);
    SampleMean mean;
    for (int i = 0; i < 200000; ++i) {
      const Environment::Sample sample = environment.sample(in_square(random));
      mean.add(double(luminance(sample.radiance)) / double(sample.pdf));
    }
    // By the middles of equal solid angles.
    double sum = 0;
    constexpr int n = 600;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < 2 * n; ++i) {
        const double y = 1 - 2 * (j + 0.5) / n, r = std::sqrt(1 - y * y), turn = M_PI * (i + 0.5) / n;
        sum += double(luminance(
            environment.radiance({float(r * std::cos(turn)), float(y), float(r * std::sin(turn))})));
      }
    const double expected = sum * sphere / (2.0 * n * n);
    CHECK(z_test(mean, expected) > sidak_level(2));
    CHECK(seen_error(mean.standard_error(), sidak_level(2)) <= 0.01 * expected);
    // Chosen by luminance, what a sample brings varies by what it varies within a pixel: far less than the
    // map.
    CHECK(std::sqrt(mean.variance()) < 0.8 * expected);
  }
}

TEST_CASE("without compensation no direction that shines lacks density") {
  for (const MapLayout layout : layouts) {
    CAPTURE(name_of(layout));
    auto map = std::make_shared<Image>(blank(layout, 12));
    Random random(10);
    for (int i = 0; i < 6; ++i)
      map->at(int(random.below(std::uint32_t(map->width))), int(random.below(12))) = {1, 0, 0};
    map->at(0, 5) = map->at(map->width - 1, 0) = {0, 0, 1};  // at the edges
    const Environment environment({map, layout}, 0);
    int shining = 0;
    for (int i = 0; i < 200000; ++i) {
      const Vec3 direction = any_direction(random);
      if (is_black(environment.radiance(direction))) continue;
      ++shining;
      REQUIRE(environment.pdf(direction) > 0);
    }
    CHECK(shining > 10000);
  }
}

TEST_CASE("compensation takes the mean away, and leaves nothing to sample of a constant sky") {
  auto sky = std::make_shared<Image>(16, 8);
  for (Rgb& pixel : sky->pixels) pixel = {0.3f, 0.7f, 0.9f};
  const Environment constant({sky}, 1);
  CHECK(constant.pdf({0, 1, 0}) == 0);
  CHECK(constant.sample({0.5f, 0.5f}).pdf == 0);
  CHECK(Environment({sky}, 0.5).pdf({0.6f, 0, 0.8f}) == Approx(1 / sphere));
  CHECK(Environment({sky}, 0).pdf({0.6f, 0, 0.8f}) == Approx(1 / sphere));
  sky->at(3, 4) = {100, 100, 100};
  const Environment sunny({sky}, 1);
  const Vec3 sun = direction_of(MapLayout::latitude_longitude, {3.5 / 16, 4.5 / 8});
  CHECK(sunny.pdf(sun) > 10 / sphere);
  CHECK(sunny.pdf(-sun) == 0);
  CHECK(mis_compensation(1) == 1);
  CHECK(mis_compensation(3) == 0.5);
}

TEST_CASE("many samples of an environment are those of each draw alone") {
  Random random(8);
  for_batches([&](const Environment& environment, std::size_t count) {
    std::vector<Vec2> draws(count);
    for (Vec2& u : draws) u = in_square(random);
    std::vector<Environment::Sample> samples(count, {{1, 2, 3}, {4, 5, 6}, 7});
    environment.sample(draws, samples);
    for (std::size_t i = 0; i < count; ++i) {
      const Environment::Sample alone = environment.sample(draws[i]);
      CHECK(samples[i].direction == alone.direction);
      CHECK(samples[i].radiance == alone.radiance);
      CHECK(samples[i].pdf == alone.pdf);
    }
  });
}

TEST_CASE("many views of an environment have the radiance and the density of each direction") {
  Random random(9);
  for_batches([&](const Environment& environment, std::size_t count) {
    std::vector<Vec3> directions(count);
    for (Vec3& direction : directions) direction = any_direction(random);
    std::vector<Environment::View> views(count, {{4, 5, 6}, 7});
    environment.view(directions, views);
    std::vector<Rgb> radiances(count + 1, {8, 9, 10});
    environment.radiance(directions, radiances);
    CHECK(radiances[count] == Rgb{8, 9, 10});
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(views[i].radiance == environment.radiance(directions[i]));
      CHECK(radiances[i] == views[i].radiance);
      CHECK(views[i].pdf == environment.pdf(directions[i]));
      CHECK(environment.view(directions[i]).radiance == views[i].radiance);
      CHECK(environment.view(directions[i]).pdf == views[i].pdf);
    }
  });
}

TEST_CASE("a black environment is not sampled") {
  const Environment night({std::make_shared<Image>(4, 2)}, 0);
  CHECK(night.pdf({0, 1, 0}) == 0);
  CHECK(night.sample({0.25f, 0.75f}).pdf == 0);
  CHECK(is_black(night.radiance({0, 0, 1})));
}

TEST_CASE("a map of more pixels than cells has the light and the density of its pixels' blocks") {
  // 3000 x 1500 pixels: cells are 2 x 2 pixels, an edge of them narrower.
  auto map = std::make_shared<Image>(3001, 1501);
  Random random(12);
  for (Rgb& pixel : map->pixels) pixel.g = random.unit();
  for (int y = 700; y < 720; ++y) map->at(3000, y) = {0, 1000, 0};
  const Environment environment({map}, 0);
  SampleMean mean;
  for (int i = 0; i < 20000; ++i) {
    const Environment::Sample sample = environment.sample(in_square(random));
    mean.add(1 / double(sample.pdf));
  }
  // All of the map shines, so that the mean of 1 / density is the sphere.
  CHECK(z_test(mean, sphere) > sidak_level(1));
  CHECK(seen_error(mean.standard_error(), sidak_level(1)) <= 0.05 * sphere);
  CHECK(environment.pdf(direction_of(MapLayout::latitude_longitude, {3000.5 / 3001, 710.5 / 1501})) >
        100 / sphere);
}

}  // namespace twinray::test
