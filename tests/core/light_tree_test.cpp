// SPDX-License-Identifier: Apache-2.0
#include "core/light_tree.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/chi_square.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

using Choice = LightTree::Choice;

LightBounds lamp(const Vec3& center, float half, double power, const EmissionCone& cone = {}) {
  LightBounds bounds;
  bounds.box.extend(center - Vec3{half, half, half});
  bounds.box.extend(center + Vec3{half, half, half});
  bounds.power = power;
  bounds.cone = cone;
  return bounds;
}

/// Small lamps anywhere in a box of side 20; every third faces one way, every seventh has no power.
std::vector<LightBounds> random_lamps(int count) {
  std::vector<LightBounds> lamps;
  Random random(4);
  for (int i = 0; i < count; ++i) {
    const Vec3 center = random.in_ball() * 10, axis = normalize(random.in_ball());
    const double power = i % 7 == 0 ? 0 : 0.1 + double(random.unit());
    lamps.push_back(lamp(center, 0.1f, power, i % 3 == 0 ? EmissionCone{axis, 0.2} : EmissionCone{}));
  }
  return lamps;
}

Receiver random_receiver(Random& random) {
  const Vec3 position = random.in_ball() * 12;
  const Vec3 normal = normalize(random.in_ball());
  return {position, normal, random.below(2) == 0};
}

/// What a point of a lamp that faces `axis` sends to a receiver, up to a factor.
double received(const LightBounds& light, const Vec3& at, const Vec3& normal, const Receiver& receiver) {
  const Vec3 towards = at - receiver.position;
  const double squared = double(length_squared(towards)), distance = std::sqrt(squared);
  const double cos_light = -double(dot(normal, towards)) / distance;
  const double cos_normal = double(dot(receiver.normal, towards)) / distance;
  const double cos_receiver = receiver.lets_light_through ? std::fabs(cos_normal) : std::max(cos_normal, 0.0);
  return cos_light > 0 ? light.power * cos_light * cos_receiver / squared : 0;
}

}  // namespace

TEST_CASE(
    "the probabilities of all lights add up to 1 at most, and picks have the probability that is stated") {
  for (const Choice choice : {Choice::importance, Choice::power}) {
    const std::vector<LightBounds> lamps = random_lamps(100);
    const LightTree tree(lamps, choice);
    Random random(5);
    for (int i = 0; i < 5; ++i) {
      Receiver receiver = random_receiver(random);
      receiver.position = receiver.position * 0.3f;  // Lamps on both sides.
      receiver.lets_light_through = i % 2 == 0;
      std::vector<double> expected;
      double sum = 0;
      for (std::uint32_t light = 0; light < lamps.size(); ++light) {
        expected.push_back(double(tree.probability(light, receiver)));
        sum += expected.back();
        if (lamps[light].power == 0) CHECK(expected.back() == 0);
      }
      // What is left is the chance that no light is found to reach the receiver.
      CHECK(sum <= 1 + 1e-5);
      expected.push_back(std::max(1 - sum, 0.0));
      constexpr int picks = 50000;
      std::vector<std::size_t> counts(lamps.size() + 1);
      for (int n = 0; n < picks; ++n) {
        const auto pick = tree.pick(receiver, random.unit());
        if (pick) REQUIRE(pick->probability == tree.probability(pick->light, receiver));
        ++counts[pick ? pick->light : lamps.size()];
      }
      for (double& count : expected) count = count * picks + 1e-3;
      check_counts(counts, expected, 10, 0.1);
    }
  }
}

TEST_CASE("what a choice leaves of a draw is a draw, and as even as the draws were") {
  const std::vector<LightBounds> lamps = random_lamps(20);
  const LightTree tree(lamps);
  Random random(9);
  constexpr std::size_t draws = 20000;
  for (int i = 0; i < 5; ++i) {
    Receiver receiver = random_receiver(random);
    receiver.lets_light_through = true;
    std::vector<std::vector<float>> rests(lamps.size());
    for (std::size_t n = 0; n < draws; ++n)
      if (const auto pick = tree.pick(receiver, (double(n) + 0.5) / draws))
        rests[pick->light].push_back(pick->rest);
    for (const std::vector<float>& rest : rests)
      for (std::size_t n = 0; n < rest.size(); ++n) {
        // Each of so many parts of [0, 1) has one, but for two at its ends and the roundings of
        // probabilities.
        CHECK(std::fabs(double(rest[n]) - (double(n) + 0.5) / double(rest.size())) <
              2.0 / double(rest.size()));
        CHECK(rest[n] < 1);
      }
  }
  const auto last = tree.pick(random_receiver(random), std::nextafter(1.0, 0.0));
  if (last) CHECK(last->rest < 1);
}

TEST_CASE("by power alone a light's probability is its share of the power, wherever it is seen from") {
  const std::vector<LightBounds> lamps = random_lamps(50);
  const LightTree tree(lamps, Choice::power);
  double sum = 0;
  for (const LightBounds& light : lamps) sum += light.power;
  Random random(6);
  const Receiver receiver = random_receiver(random);
  for (std::uint32_t light = 0; light < lamps.size(); ++light)
    CHECK(tree.probability(light, receiver) == Approx(lamps[light].power / sum).epsilon(1e-5));
}

TEST_CASE("no light that reaches a receiver has the probability 0") {
  const std::vector<LightBounds> lamps = random_lamps(300);
  const LightTree tree(lamps);
  Random random(7);
  int lit = 0;
  for (int i = 0; i < 20000; ++i) {
    const Receiver receiver = random_receiver(random);
    const std::uint32_t light = random.below(300);
    const LightBounds& lamp = lamps[light];
    // A point of its box, with a normal within its cone.
    const Vec3 at = lamp.box.lower + Vec3{random.unit(), random.unit(), random.unit()} * 0.2f;
    Vec3 normal = normalize(random.in_ball());
    if (lamp.cone.normals < 3) normal = normalize(lamp.cone.axis + normal * 0.19f);
    if (!(received(lamp, at, normal, receiver) > 0)) continue;
    ++lit;
    REQUIRE(tree.probability(light, receiver) > 0);
  }
  CHECK(lit > 5000);
}

TEST_CASE("a lamp behind a surface is chosen where that lets light through, and else not") {
  const std::vector<LightBounds> lamps{lamp({0, 5, 0}, 0.1f, 1, {}), lamp({0, -5, 0}, 0.1f, 1, {})};
  const LightTree tree(lamps);
  const Receiver floor{{0, 0, 0}, {0, 1, 0}}, glass{{0, 0, 0}, {0, 1, 0}, true};
  CHECK(tree.probability(0, floor) == 1);
  CHECK(tree.probability(1, floor) == 0);
  CHECK(tree.probability(0, glass) == Approx(0.5));
  CHECK(tree.probability(1, glass) == Approx(0.5));
}

TEST_CASE("a point in a medium is lit by lamps on all sides of it alike") {
  const std::vector<LightBounds> lamps{lamp({0, 5, 0}, 0.1f, 1, {}), lamp({0, 0, -5}, 0.1f, 1, {})};
  const LightTree tree(lamps);
  CHECK(tree.probability(0, Receiver{{}, {}, true}) == Approx(0.5));
  CHECK(tree.probability(1, Receiver{{}, {}, true}) == Approx(0.5));
  // By the squared distances, 4 and 34.
  CHECK(tree.probability(1, Receiver{{0, 0, -3}, {}, true}) == Approx(34.0 / 38).epsilon(0.01));
}

TEST_CASE("a lamp is found from where the middle of those beside it cannot be seen") {
  // Stairs of lamps that all face up: a receiver over a lower one lies below the middle of them all.
  std::vector<LightBounds> lamps;
  for (int i = 0; i < 64; ++i)
    lamps.push_back(lamp({float(i), 0.25f * float(i), 0}, 0.01f, 1, EmissionCone{{0, 1, 0}, 0}));
  const LightTree tree(lamps);
  for (std::uint32_t light = 0; light < 64; ++light)
    for (const float side : {-3.0f, -1.0f, 0.5f}) {
      const Vec3 above = Vec3{float(light) + side, 0.25f * float(light) + 0.1f, 0};
      CAPTURE(light, side);
      CHECK(tree.probability(light, {above, {0, -1, 0}}) > 0);
    }
}

TEST_CASE("the importance of bounds is at least what each of its lights sends") {
  Random random(8);
  const std::vector<LightBounds> lamps = random_lamps(30);
  for (int i = 0; i < 20000; ++i) {
    const LightBounds &a = lamps[random.below(30)], &b = lamps[random.below(30)];
    const LightNode node(together(a, b));
    const Receiver receiver = random_receiver(random);
    for (const LightBounds& light : {a, b}) {
      const Vec3 center = (light.box.lower + light.box.upper) * 0.5f;
      const Vec3 normal = light.cone.normals < 3 ? light.cone.axis : normalize(random.in_ball());
      const double squared = double(length_squared(node.center - receiver.position));
      // By the distance to the middle: that to the light itself may be less.
      const double sent = received(light, center, normal, receiver) *
                          double(length_squared(center - receiver.position)) /
                          std::max(squared, double(node.squared_radius));
      REQUIRE(double(node.importance(receiver)) >= sent * (1 - 1e-3) - 1e-9);
    }
  }
}

TEST_CASE("a cone around two cones holds both") {
  const auto cone_of = [](const EmissionCone& a, const EmissionCone& b) {
    return together(lamp({0, 0, 0}, 1, 1, a), lamp({0, 0, 0}, 1, 1, b)).cone;
  };
  const EmissionCone both = cone_of({{1, 0, 0}, 0.1}, {{0, 1, 0}, 0.3});
  CHECK(both.normals == Approx((0.1 + 0.3 + M_PI / 2) / 2));
  CHECK(double(dot(both.axis, Vec3{1, 0, 0})) == Approx(std::cos(both.normals - 0.1)));
  CHECK(double(dot(both.axis, Vec3{0, 1, 0})) == Approx(std::cos(both.normals - 0.3)));
  CHECK(cone_of({{1, 0, 0}, 0.1}, {{1, 0, 0}, 0.3}).normals == 0.3);
  CHECK(cone_of({{1, 0, 0}, 0.1}, {{-1, 0, 0}, 0.1}).normals == Approx(M_PI));
  CHECK(cone_of({{1, 0, 0}, 0, 0.2}, {{1, 0, 0}, 0, 0.7}).emission == 0.7);
}

TEST_CASE("a tree of 100,000 lights is some twenty levels deep, and one of coincident lights is balanced") {
  CHECK(LightTree(random_lamps(100000)).depth() <= 30);
  CHECK(LightTree(std::vector<LightBounds>(1024, lamp({1, 2, 3}, 0, 1))).depth() == 11);
  CHECK(LightTree(std::vector<LightBounds>(1, lamp({1, 2, 3}, 0, 1))).depth() == 1);
  // Ever farther apart: each split takes a few off the end.
  std::vector<LightBounds> line;
  for (int i = 0; i < 120; ++i) line.push_back(lamp({std::ldexp(1.0f, i - 60), 0, 0}, 0, 1));
  CHECK(LightTree(line).depth() <= 60);
}

TEST_CASE("a tree without light picks none") {
  const Receiver receiver{{0, 0, 0}, {0, 1, 0}};
  CHECK_FALSE(LightTree().pick(receiver, 0.5f));
  CHECK_FALSE(LightTree(std::vector<LightBounds>(3, lamp({0, 1, 0}, 0, 0))).pick(receiver, 0.5f));
  // It faces away.
  const std::vector<LightBounds> away(2, lamp({0, 5, 0}, 0.1f, 1, {{0, 1, 0}, 0.1}));
  CHECK_FALSE(LightTree(away).pick(receiver, 0.5f));
  CHECK(LightTree(away).probability(0, receiver) == 0);
}

TEST_CASE("lights close by are picked far more often than by their power") {
  std::vector<LightBounds> lamps;
  for (int x = 0; x < 32; ++x)
    for (int z = 0; z < 32; ++z) lamps.push_back(lamp({float(x), 1, float(z)}, 0.1f, 1, {{0, -1, 0}, 0}));
  const LightTree tree(lamps);
  // The spread of what a pick brings over its probability, relative to the mean: the noise of one sample.
  const auto spread = [&](const LightTree& by) {
    const Receiver receiver{{7.3f, 0, 12.4f}, {0, 1, 0}};
    double mean = 0, squares = 0;
    for (std::uint32_t i = 0; i < lamps.size(); ++i) {
      const Vec3 center = (lamps[i].box.lower + lamps[i].box.upper) * 0.5f;
      const double sent = received(lamps[i], center, {0, -1, 0}, receiver);
      mean += sent;
      squares += sent * sent / double(by.probability(i, receiver));
    }
    return squares / (mean * mean) - 1;
  };
  CHECK(spread(tree) < 0.15 * spread(LightTree(lamps, Choice::power)));
}

}  // namespace twinray::test
