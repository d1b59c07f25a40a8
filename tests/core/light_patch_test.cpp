// SPDX-License-Identifier: Apache-2.0
#include "core/light_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/meshes.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

constexpr Receiver receiver_below{{0.2f, -1, 0.3f}, {0, 1, 0}};

/// A parallelogram of two triangles, whose vertices begin at the given corners of them.
Mesh two_triangles(int first, int second) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 2}, {3, 0, 2.5f}, {3, 0, 0.5f}};
  const Triangle one{0, 1, 2}, two{0, 2, 3};
  const auto turned = [](const Triangle& t, int by) {
    return Triangle{t[std::size_t(by % 3)], t[std::size_t((by + 1) % 3)], t[std::size_t((by + 2) % 3)]};
  };
  mesh.triangles = {turned(one, first), turned(two, second)};
  return mesh;
}

Mesh one_triangle() {
  Mesh mesh;
  mesh.positions = {{-1, 1, -1}, {1, 1, -1}, {0.5f, 1, 2}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += 0.5 * length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
  return area;
}

PatchLight light_of(const Mesh& mesh, EmissionSide side = EmissionSide::both) {
  return patch_light(mesh, side, area_of(mesh));
}

Vec3 position_of(const Mesh& mesh, const PatchWeights::Choice& choice) {
  const auto& [a, b, c] = mesh.triangles[choice.triangle];
  return mesh.positions[a] * (1 - choice.u - choice.v) + mesh.positions[b] * choice.u +
         mesh.positions[c] * choice.v;
}

Mesh trapezoid() {
  Mesh mesh = two_triangles(2, 1);
  mesh.positions[2].x = 2;
  return mesh;
}

std::vector<Mesh> lamps() {
  return {floor_square(1, 1), two_triangles(1, 2), one_triangle(), trapezoid(), box_mesh()};
}

/// Of the light that arrives from a lamp without anything in its way, by one sample of it.
SampleMean arriving(const Mesh& mesh, const Receiver& receiver, bool by_corners) {
  const PatchLight light = light_of(mesh);
  const PatchWeights weights(light, receiver);
  Random random(4);
  SampleMean mean;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 u = in_square(random);
    PatchWeights::Choice choice = weights.choose(u);
    if (!by_corners) {  // A single parallelogram, by area.
      const std::size_t half = u.y <= u.x ? 0 : 1;
      choice = {light.patches[0].triangles[half], std::fabs(u.x - u.y), std::min(u.x, u.y), 1};
    }
    const Vec3 between = position_of(mesh, choice) - receiver.position;
    const double squared = length_squared(between);
    const double cosines = std::max(0.0f, dot(receiver.normal, between)) *
                           std::fabs(dot(light.patches[0].normal, between)) / squared;
    mean.add(cosines / squared / choice.density);
  }
  return mean;
}

}  // namespace

TEST_CASE("two triangles are one patch where they form a parallelogram") {
  for (int first = 0; first < 3; ++first)
    for (int second = 0; second < 3; ++second) {
      const PatchLight light = light_of(two_triangles(first, second));
      REQUIRE(light.patches.size() == 1);
      CHECK(light.patches[0].is_parallelogram);
      CHECK(light.patches[0].share == Approx(1));
    }
  CHECK(light_of(one_triangle()).patches.size() == 1);
  CHECK(light_of(trapezoid()).patches.size() == 2);
  CHECK(light_of(box_mesh()).patches.size() == 6);
  Mesh turned_over = two_triangles(0, 0);
  std::swap(turned_over.triangles[1][1], turned_over.triangles[1][2]);
  CHECK(light_of(turned_over).patches.size() == 2);
}

TEST_CASE("a light of many patches, or of a minute one, has none") {
  CHECK(light_of(icosphere(1)).patches.empty());
  CHECK(patch_light(one_triangle(), EmissionSide::both, 0).patches.empty());
  Mesh uneven = one_triangle();
  uneven.positions.insert(uneven.positions.end(), {{0, 0, 0}, {1e-4f, 0, 0}, {0, 1e-4f, 0}});
  uneven.triangles.push_back({3, 4, 5});
  CHECK(light_of(uneven).patches.empty());
}

TEST_CASE("points of patches lie where their density says") {
  // In each cell of the bounding box's floor plan, the mean of 1 / density is the area there: that of points
  // chosen by area.
  constexpr int side = 4;
  constexpr int samples = 50000;
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<Mesh> all = lamps();
  for (std::size_t number = 0; number < all.size(); ++number) {
    const Mesh& mesh = all[number];
    const PatchLight light = light_of(mesh);
    const PatchWeights weights(light, receiver_below), uniform(light, {{infinite, 0, 0}, {1, 0, 0}});
    const auto cell_of = [&](const PatchWeights::Choice& choice) {
      const Vec3 p = position_of(mesh, choice);
      const auto index = [](float x) { return std::clamp(int((x + 1.5f) * side / 4), 0, side - 1); };
      return std::size_t(index(p.x) * side + index(p.z));
    };
    Random random(number);
    std::vector<SampleMean> chosen(side * side), by_area(side * side);
    for (int i = 0; i < samples; ++i) {
      const PatchWeights::Choice choice = weights.choose(in_square(random)),
                                 other = uniform.choose(in_square(random));
      REQUIRE(other.density == 1);
      for (std::size_t cell = 0; cell < chosen.size(); ++cell) {
        chosen[cell].add(cell_of(choice) == cell ? 1 / double(choice.density) : 0);
        by_area[cell].add(cell_of(other) == cell ? 1 : 0);
      }
    }
    const double level = sidak_level(int(all.size()) * side * side);
    for (std::size_t cell = 0; cell < chosen.size(); ++cell) {
      CAPTURE(number, cell);
      const double error = std::hypot(chosen[cell].standard_error(), by_area[cell].standard_error());
      CHECK(z_test(chosen[cell].mean() - by_area[cell].mean(), error, 0) > level);
      CHECK(seen_error(error, level) < 0.03);  // Of the light's area.
    }
  }
}

TEST_CASE("the density of a chosen point is the density that is asked for") {
  for (const Mesh& mesh : lamps())
    for (const EmissionSide side : {EmissionSide::front, EmissionSide::back, EmissionSide::both}) {
      const PatchLight light = light_of(mesh, side);
      const PatchWeights weights(light, receiver_below);
      Random random(8);
      for (int i = 0; i < 2000; ++i) {
        const PatchWeights::Choice choice = weights.choose(in_square(random));
        CHECK(weights.density(choice.triangle, choice.u, choice.v) == Approx(choice.density).epsilon(1e-4));
      }
    }
}

TEST_CASE("from a wall, points chosen by the corners have a tenth of the variance of those by area") {
  const Receiver wall{{-1, 0.4f, 0.2f}, {1, 0, 0}};
  Mesh lamp = floor_square(0.4f, 1);
  const SampleMean by_area = arriving(lamp, wall, false), by_corners = arriving(lamp, wall, true);
  CHECK(by_corners.variance() < 0.1 * by_area.variance());
  const double error = std::hypot(by_area.standard_error(), by_corners.standard_error());
  CHECK(z_test(by_corners.mean() - by_area.mean(), error, 0) > sidak_level(1));
  CHECK(seen_error(error, sidak_level(1)) < 0.02 * by_area.mean());
}

TEST_CASE("a patch that faces away is chosen seldom, and no point much too seldom") {
  const Mesh box = box_mesh();
  const PatchLight light = light_of(box, EmissionSide::front);
  const PatchWeights weights(light, {{0.5f, -3, 0.5f}, {0, 1, 0}});  // Sees the lower face alone.
  constexpr float least = PatchLight::floor / (1 + PatchLight::floor);
  Random random(9);
  int away = 0;
  for (int i = 0; i < 10000; ++i) {
    const PatchWeights::Choice choice = weights.choose(in_square(random));
    CHECK(choice.density >= 0.999f * least);
    const auto& [a, b, c] = box.triangles[choice.triangle];
    away += cross(box.positions[b] - box.positions[a], box.positions[c] - box.positions[a]).y >= 0;
  }
  CHECK(away > 100);
  CHECK(away < 1000);  // 5/6 by area.
}

TEST_CASE("a point in a medium sees patches on all sides of it alike") {
  // Squares that face it, above it and below.
  Mesh both = floor_square(1, -2);
  const auto corners = std::uint32_t(both.positions.size());
  for (const Vec3& p : floor_square(1, 2).positions) both.positions.push_back(p);
  for (const auto& [a, b, c] : floor_square(1, 2).triangles)
    both.triangles.push_back({a + corners, c + corners, b + corners});
  const PatchLight light = light_of(both, EmissionSide::front);
  REQUIRE(light.patches.size() == 2);
  const auto density_of = [&](std::uint32_t triangle, const Vec3& from) {
    return PatchWeights(light, Receiver{from, {}, true}).density(triangle, 0.2f, 0.3f);
  };
  CHECK(density_of(0, {}) == Approx(1).epsilon(0.1));
  CHECK(density_of(2, {}) == Approx(1).epsilon(0.1));
  CHECK(density_of(2, {0, 1, 0}) > 2 * density_of(0, {0, 1, 0}));
}

TEST_CASE("a light is sampled by area where its corners tell nothing") {
  const Mesh square = floor_square(1, 1);
  const PatchLight light = light_of(square);
  const float huge = 1e12f, infinite = std::numeric_limits<float>::infinity();
  for (const Receiver& receiver :
       {Receiver{{0, 1, 0}, {0, 1, 0}}, Receiver{{0, 0, 0}, {0, -1, 0}},
        Receiver{square.positions[0], {0, 1, 0}}, Receiver{{infinite, 0, 0}, {1, 0, 0}}})
    CHECK(PatchWeights(light, receiver).choose({0.3f, 0.6f}).density == 1);
  // Far away the corners still tell, and nothing overflows.
  const float density = PatchWeights(light, {{huge, -huge, 0}, {0, 1, 0}}).choose({0.3f, 0.6f}).density;
  CHECK(density == Approx(1).epsilon(1e-3));
}

}  // namespace twinray::test
