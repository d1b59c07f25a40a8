// SPDX-License-Identifier: Apache-2.0
#include "integrators/flight.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

const Interior grey_medium{.absorption = {0.2f, 0.2f, 0.2f}, .scattering = {0.8f, 0.8f, 0.8f}};
const Interior colored{.absorption = {0.1f, 0, 0.5f}, .scattering = {0.3f, 2, 5}};
/// Green light goes through it as through nothing.
const Interior partial{.absorption = {0.5f, 0, 0}, .scattering = {1, 0, 0.25f}};
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Along a ray of some length.
MediumColumn column_of(const Interior& medium, float length) {
  static const Scene scene;
  static const Ray ray{.origin = {1, 2, 3}, .direction = {0, 0, 1}};
  return {scene, medium, ray, length};
}

/// A medium and the way through it.
struct Stretch {
  const Interior& medium;
  float length;
};

/// Sums of weights, over draws that are even in [0, 1): of flights that go through, and of those that end.
struct Sums {
  Rgb through, scattered;
};

Sums sums_of(const std::vector<Stretch>& stretches, const Rgb& throughput) {
  constexpr int draws = 1 << 16;
  double through[3] = {}, scattered[3] = {};
  for (int i = 0; i < draws; ++i) {
    Flight flight(throughput, (float(i) + 0.5f) / draws);
    bool has_ended = false;
    for (const Stretch& each : stretches) {
      has_ended = flight.ends_within(each.medium, column_of(each.medium, each.length));
      if (has_ended) {
        CHECK_FALSE(flight.distance() < 0);
        CHECK_FALSE(flight.distance() > each.length);
        break;
      }
    }
    const Rgb weight = flight.weight();
    double* const sum = has_ended ? scattered : through;
    sum[0] += double(weight.r) / draws;
    sum[1] += double(weight.g) / draws;
    sum[2] += double(weight.b) / draws;
  }
  const auto color = [](const double* sum) { return Rgb{float(sum[0]), float(sum[1]), float(sum[2])}; };
  return {color(through), color(scattered)};
}

/// What goes through unscattered, and what is scattered once, of light of one channel.
struct Exact {
  double through = 1, scattered = 0;

  void add(double absorption, double scattering, double length) {
    const double extinction = absorption + scattering;
    const double kept = extinction > 0 ? std::exp(-extinction * length) : 1;
    if (extinction > 0) scattered += through * scattering / extinction * (1 - kept);
    through *= kept;
  }
};

void check_sums(const std::vector<Stretch>& stretches, const Rgb& throughput) {
  const Sums sums = sums_of(stretches, throughput);
  Exact r, g, b;
  for (const auto& [medium, length] : stretches) {
    r.add(double(medium.absorption.r), double(medium.scattering.r), double(length));
    g.add(double(medium.absorption.g), double(medium.scattering.g), double(length));
    b.add(double(medium.absorption.b), double(medium.scattering.b), double(length));
  }
  const auto near = [](double x) { return Approx(x).epsilon(2e-3).margin(1e-6); };
  CHECK(sums.through.r == near(r.through));
  CHECK(sums.through.g == near(g.through));
  CHECK(sums.through.b == near(b.through));
  CHECK(sums.scattered.r == near(r.scattered));
  CHECK(sums.scattered.g == near(g.scattered));
  CHECK(sums.scattered.b == near(b.scattered));
}

}  // namespace

TEST_CASE("the weights of flights have the mean that light has, whatever their channel is chosen by") {
  for (const Rgb& throughput : {Rgb{1, 1, 1}, Rgb{0.1f, 3, 0.5f}, Rgb{1e-6f, 1e-6f, 1e-5f}}) {
    check_sums({{grey_medium, 1}}, throughput);
    check_sums({{grey_medium, infinity}}, throughput);
    check_sums({{colored, 0.5f}}, throughput);
    check_sums({{colored, infinity}}, throughput);
    check_sums({{partial, 2}}, throughput);
    check_sums({{grey_medium, 0.3f}, {colored, 0.2f}, {partial, 1}, {grey_medium, infinity}}, throughput);
  }
}

TEST_CASE("a medium of one color gives flights that all weigh its albedo") {
  for (const float u : {0.0f, 0.1f, 0.4f, 0.9f, 0x1.fffffep-1f}) {
    Flight flight({1, 1, 1}, u);
    REQUIRE(flight.ends_within(grey_medium, column_of(grey_medium, infinity)));
    CHECK(flight.weight().r == Approx(0.8).epsilon(1e-5));
    CHECK(flight.weight().b == Approx(0.8).epsilon(1e-5));
  }
}

TEST_CASE("a flight never goes by a channel in which the path has no light") {
  for (const float u : {0.0f, 0.5f, 0x1.fffffep-1f}) {
    // Only green, for which the medium is not there.
    Flight flight({0, 2, 0}, u);
    CHECK_FALSE(flight.ends_within(partial, column_of(partial, infinity)));
    CHECK(flight.weight().g == 1);
    // Red alone, with draws up to the end of all.
    Flight red({3, 0, 0}, u);
    CHECK(red.ends_within(colored, column_of(colored, infinity)));
    CHECK(std::isfinite(red.weight().r));
  }
}

TEST_CASE("a draw that is rounded up to all chances goes by no channel that the path does not have") {
  const Interior blue{.scattering = {0, 0, 1}};
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    Flight flight({random.unit(), random.unit(), 0}, 0x1.fffffep-1f);
    REQUIRE_FALSE(flight.ends_within(blue, column_of(blue, 100)));
    REQUIRE(flight.weight().r == Approx(1));
  }
}

TEST_CASE("no channel of a flight weighs more than the reciprocal of its chance") {
  for (int i = 0; i < 1000; ++i) {
    Flight through({1, 1, 1}, (float(i) + 0.5f) / 1000);
    through.ends_within(colored, column_of(colored, 1));
    CHECK(max_component(through.weight()) <= 3 * (1 + 1e-5f));
  }
}

TEST_CASE("no way is too short or too long for a flight") {
  Flight flight({1, 1, 1}, 0.25f);
  CHECK_FALSE(flight.ends_within(grey_medium, column_of(grey_medium, 0)));
  CHECK(flight.weight() == Rgb{1, 1, 1});
  CHECK(flight.ends_within(grey_medium, column_of(grey_medium, 1e30f)));
  CHECK(std::isfinite(flight.distance()));
  // Nor is a medium too thin: it is none.
  const Interior thin{.scattering = {1e-45f, 1e-38f, 1e-31f}};
  Flight through_thin({1, 1, 1}, 0.5f);
  CHECK_FALSE(through_thin.ends_within(thin, column_of(thin, infinity)));
  CHECK(through_thin.weight() == Rgb{1, 1, 1});
  Flight through_dense({1, 1, 1}, 0x1.fffffep-1f);
  const Interior dense{.scattering = {1e30f, 1e30f, 1e30f}};
  CHECK(through_dense.ends_within(dense, column_of(dense, 1)));
  CHECK(std::isfinite(through_dense.weight().r));
}

}  // namespace twinray::test
