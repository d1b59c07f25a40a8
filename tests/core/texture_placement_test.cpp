// SPDX-License-Identifier: Apache-2.0
#include "core/texture_placement.h"

#include <cmath>
#include <limits>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

/// Where a pattern is asked for that is placed at twice its size around (1, 2, 3).
TexturePoint asked(TexturePlacement placement, const Vec3& position, float width = 0) {
  const PointTransform half{{{0.5f, 0, 0, -0.5f}, {0, 0.5f, 0, -1}, {0, 0, 0.5f, -1.5f}}};
  return placed_point({0, placement, half},
                      {.uv = {7, 8}, .footprint = 9, .position = position, .width = width});
}

void check_uv(const TexturePoint& at, float u, float v) {
  CHECK(at.uv.x == Approx(u).margin(1e-6));
  CHECK(at.uv.y == Approx(v).margin(1e-6));
  CHECK(at.second_uv == at.uv);
  CHECK(at.second_footprint == at.footprint);
}

}  // namespace

TEST_CASE("a pattern in space is asked for at its own point, and keeps the surface's coordinates") {
  const TexturePoint at = asked(TexturePlacement::space, {2, 4, 8}, 3);
  CHECK(at.position == Vec3{0.5f, 1, 2.5f});
  CHECK(at.width == Approx(1.5));
  CHECK(at.uv == Vec2{7, 8});
  CHECK(at.footprint == 9);
}

TEST_CASE("a pattern in a plane has x and y for its coordinates") {
  const TexturePoint at = asked(TexturePlacement::planar, {2, 4, 8}, 3);
  check_uv(at, 0.5f, 1);
  CHECK(at.footprint == Approx(1.5));
}

TEST_CASE("a pattern around a sphere has the angle from z in half turns, and that around it in turns") {
  check_uv(asked(TexturePlacement::spherical, {1, 2, 5}), 0, 0);
  check_uv(asked(TexturePlacement::spherical, {1, 2, 1}), 1, 0);
  check_uv(asked(TexturePlacement::spherical, {2, 2, 3}), 0.5f, 0);
  check_uv(asked(TexturePlacement::spherical, {1, 4, 3}), 0.5f, 0.25f);
  check_uv(asked(TexturePlacement::spherical, {1, 1, 3}), 0.5f, 0.75f);
  check_uv(asked(TexturePlacement::spherical, {-1, 2, 5}), 0.25f, 0.5f);
}

TEST_CASE("a pattern around a cylinder has the angle from -x in turns, and z") {
  check_uv(asked(TexturePlacement::cylindrical, {2, 2, 5}), 0.5f, 1);
  check_uv(asked(TexturePlacement::cylindrical, {1, 4, 3}), 0.75f, 0);
  check_uv(asked(TexturePlacement::cylindrical, {1, 1, 1}), 0.25f, -1);
  check_uv(asked(TexturePlacement::cylindrical, {0, 2, 3}), 1, 0);
}

TEST_CASE("a footprint around an axis is how far the coordinates change on the surface") {
  for (const TexturePlacement placement : {TexturePlacement::spherical, TexturePlacement::cylindrical})
    for (const Vec3 p : {Vec3{3, 2.5f, 4}, Vec3{0, 5, -1}, Vec3{2, 2.5f, 3}}) {
      // The area of a small square of two directions that follow the coordinates.
      const Vec3 from_axis{p.x - 1, p.y - 2, 0}, from_center = p - Vec3{1, 2, 3};
      const Vec3 around = normalize(Vec3{-from_axis.y, from_axis.x, 0});
      const bool is_sphere = placement == TexturePlacement::spherical;
      const Vec3 up = is_sphere ? normalize(cross(around, from_center)) : Vec3{0, 0, 1};
      constexpr float step = 0.01f;
      const auto change = [&](const Vec3& direction) {
        const Vec2 d = asked(placement, p + direction * step).uv - asked(placement, p - direction * step).uv;
        return std::sqrt(d.x * d.x + d.y * d.y) / (2 * step);
      };
      CHECK(asked(placement, p, 0.5f).footprint ==
            Approx(0.5 * std::sqrt(change(around) * change(up))).epsilon(1e-3));
    }
  CHECK(asked(TexturePlacement::spherical, {1, 2, 5}, 1).footprint == 0);
  CHECK(asked(TexturePlacement::cylindrical, {1, 2, 5}, 1).footprint == 0);
}

TEST_CASE("a point that is not finite places a pattern at its origin") {
  constexpr float most = std::numeric_limits<float>::max();
  const PointTransform large{{{most, most, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  for (const TexturePlacement placement : {TexturePlacement::space, TexturePlacement::planar,
                                           TexturePlacement::spherical, TexturePlacement::cylindrical})
    CHECK(placed_point({0, placement, large}, {.position = {2, 2, 2}}).position == Vec3{});
}

TEST_CASE("a map's mean stretch is that of its axes") {
  CHECK(mean_stretch({}) == 1);
  CHECK(mean_stretch({{{3, 0, 0, 9}, {0, 0, 2, 9}, {4, 0, 0, 9}}}) == Approx((5.0 + 0 + 2) / 3));
}

}  // namespace twinray::test
