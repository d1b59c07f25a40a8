// SPDX-License-Identifier: Apache-2.0
#include "core/map_points.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

/// Of all lengths; along axes, planes and diagonals, with both signs of zero, and anywhere.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  constexpr float components[] = {-1, -0.5f, -1e-30f, -0.0f, 0, 1e-30f, 0.125f, 1, 1e30f};
  for (const float x : components)
    for (const float y : components)
      for (const float z : components)
        if (x != 0 || y != 0 || z != 0) all.push_back({x, y, z});
  test::Random random(184);
  for (int i = 0; i < 20000; ++i)
    all.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  return all;
}

bool same_bits(const MapPoint& a, const MapPoint& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y);
}

}  // namespace

TEST_CASE("the points of directions have in lanes the bits that each has alone") {
  const std::vector<Vec3> all = directions();
  std::vector<MapPointsKernel> kernels = map_points_kernels();
  kernels.push_back({"the fastest", map_points});
  for (const MapPointsKernel& kernel : kernels)
    for (const MapLayout layout : {MapLayout::latitude_longitude, MapLayout::equal_area}) {
      CAPTURE(kernel.name, layout);
      std::vector<MapPoint> points(all.size());
      kernel.map_points(layout, all, points);
      int others = 0;
      for (std::size_t i = 0; i < all.size(); ++i) others += !same_bits(points[i], map_point(layout, all[i]));
      CHECK(others == 0);
    }
}

TEST_CASE("no more points are written than there are directions") {
  const std::vector<Vec3> all = directions();
  for (const MapPointsKernel& kernel : map_points_kernels())
    for (std::size_t count = 0; count <= 17; ++count) {
      CAPTURE(kernel.name, count);
      const std::vector<Vec3> some(all.begin(), all.begin() + std::ptrdiff_t(count));  // None behind them.
      std::vector<MapPoint> points(20, MapPoint{-1, -2});
      kernel.map_points(MapLayout::equal_area, some, points);
      for (std::size_t i = 0; i < points.size(); ++i)
        CHECK(same_bits(points[i], i < count ? map_point(MapLayout::equal_area, all[i]) : MapPoint{-1, -2}));
    }
}

}  // namespace twinray
