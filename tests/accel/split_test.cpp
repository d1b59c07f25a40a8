// SPDX-License-Identifier: Apache-2.0
#include "accel/build/split.h"

#include <algorithm>
#include <limits>

#include "accel/build/cost_model.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr double rounding = 1e-5;  // Areas are added in float.

BuildPrimitives random_boxes(Random& random, int count, float size) {
  BuildPrimitives primitives;
  for (int i = 0; i < count; ++i) {
    const Vec3 center = random.in_cube();
    Aabb box;
    box.extend(center + random.in_cube(size));
    box.extend(center + random.in_cube(size));
    primitives.push_back({box, {0, std::uint32_t(i)}});
  }
  return primitives;
}

double side_cost(std::span<const BuildPrimitive> side, const CostModel& cost) {
  Aabb box;
  for (const BuildPrimitive& primitive : side) box.extend(primitive.box);
  return box.half_area() * double(cost.counted(side.size()));
}

/// The weighted area of the first `count` primitives and the others.
double weighted_area(std::span<const BuildPrimitive> primitives, std::size_t count, const CostModel& cost) {
  return side_cost(primitives.first(count), cost) + side_cost(primitives.subspan(count), cost);
}

/// The least over all partitions of the primitives between two centres on one axis.
double least_weighted_area(BuildPrimitives primitives, const CostModel& cost) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(primitives.begin(), primitives.end(),
              [axis](const auto& a, const auto& b) { return a.center()[axis] < b.center()[axis]; });
    for (std::size_t count = 1; count < primitives.size(); ++count)
      least = std::min(least, weighted_area(primitives, count, cost));
  }
  return least;
}

}  // namespace

TEST_CASE("a few primitives are parted in the cheapest of all ways, or not at all where a leaf costs less") {
  Random random(3);
  int leaves = 0, divided = 0;
  for (int i = 0; i < 3000; ++i) {
    BuildPrimitives primitives = random_boxes(random, 2 + random.below(7), random.below(2) ? 0.1f : 1.0f);
    BuildOptions options{.max_leaf_size = 1 + random.below(8)};
    options.leaf_block = random.below(2) ? 1 : 4;
    options.traversal_cost = 0.25f + 4 * random.unit();
    const CostModel cost(options);
    const std::size_t size = primitives.size();
    const NodeRange range(primitives);
    const double area = range.box.half_area(), least = least_weighted_area(primitives, cost);
    const std::size_t count = divide_by_sah(range, options);
    if (count == 0) {
      ++leaves;
      REQUIRE(int(size) <= options.max_leaf_size);
      REQUIRE(cost.leaf(size) <= cost.split(area, least, size) * (1 + rounding));
      continue;
    }
    ++divided;
    REQUIRE(weighted_area(primitives, count, cost) == Approx(least).epsilon(rounding));
    if (int(size) <= options.max_leaf_size)
      REQUIRE(cost.split(area, least, size) <= cost.leaf(size) * (1 + rounding));
  }
  CHECK(leaves > 300);
  CHECK(divided > 1000);
}

TEST_CASE("a sample of many primitives parts two clusters between them") {
  Random random(4);
  for (const int size : {9, 5000, 40000, 100000}) {
    BuildPrimitives primitives = random_boxes(random, size, 0.01f);
    std::size_t far = 0;
    for (BuildPrimitive& primitive : primitives)
      if (random.below(3) == 0) {
        ++far;
        primitive.box.lower.y += 10;
        primitive.box.upper.y += 10;
      }
    CHECK(divide_by_sah(NodeRange(primitives), {.max_leaf_size = 1}) == primitives.size() - far);
    CHECK(std::all_of(primitives.begin(), primitives.end() - std::ptrdiff_t(far),
                      [](const BuildPrimitive& primitive) { return primitive.box.lower.y < 5; }));
  }
}

TEST_CASE("centres too close for bins are halved") {
  BuildPrimitives primitives;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const float x = float(i) * 1e-35f;
    primitives.push_back({{{x, 0, 0}, {x, 0, 0}}, {0, i}});
  }
  const NodeRange range(primitives);
  REQUIRE(!range.is_coincident());
  CHECK(divide_by_sah(range, {.max_leaf_size = 1}) == 50);
}

TEST_CASE("a range knows its boxes, on many threads too") {
  Random random(5);
  BuildPrimitives primitives = random_boxes(random, 70000, 0.1f);
  REQUIRE(primitives.size() > parallel_range);
  Aabb box, centers;
  for (const BuildPrimitive& primitive : primitives) {
    box.extend(primitive.box);
    centers.extend(primitive.center());
  }
  const NodeRange range(primitives);
  CHECK(range.box == box);
  CHECK(range.centers == centers);
}

TEST_CASE("parting keeps every primitive and puts the first ones first") {
  Random random(6);
  BuildPrimitives primitives = random_boxes(random, 1000, 0.1f);
  const auto is_first = [](const BuildPrimitive& primitive) { return primitive.id.primitive % 3 == 0; };
  const std::size_t count = part(primitives, is_first);
  CHECK(count == 334);
  CHECK(std::is_partitioned(primitives.begin(), primitives.end(), is_first));
  std::sort(primitives.begin(), primitives.end(),
            [](const auto& a, const auto& b) { return a.id.primitive < b.id.primitive; });
  for (std::uint32_t i = 0; i < 1000; ++i) REQUIRE(primitives[i].id.primitive == i);
}
