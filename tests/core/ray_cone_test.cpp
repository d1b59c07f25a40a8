// SPDX-License-Identifier: Apache-2.0
#include "core/ray_cone.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

/// Relative, of a few floats.
constexpr double rounding = 1e-6;

Camera wide_camera() {
  Camera camera;
  camera.tan_half_width = 0.8f;
  camera.tan_half_height = 0.4f;
  return camera;
}

/// A rectangle 2 wide and 8 high in the plane z = 0, whose coordinates run to `u` and `v`.
Geometry rectangle(float u, float v) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 8, 0}, {0, 8, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (u > 0) {
    mesh.uvs = {{0, 0}, {u, 0}, {u, v}, {0, v}};
    mesh.uv_indices = mesh.triangles;
  }
  return Geometry({mesh});
}

float footprint(const Geometry& geometry, float width, const Vec3& direction,
                CoordinateSet set = CoordinateSet::first) {
  Hit hit;
  hit.t = 1, hit.u = hit.v = 0.3f;
  hit.primitive = hit.mesh = 0;
  return texture_footprint(geometry, hit, surface_at(geometry, hit), width, direction, set);
}

}  // namespace

TEST_CASE("a camera's cone is as wide as a pixel, or as one's part that a sample stands for") {
  // 160 x 80 pixels: 0.01 wide at a distance of 1.
  const RayCone one = pixel_cone(wide_camera(), 160, 80);
  CHECK(one.width == 0);
  CHECK(one.at(5).width == Approx(0.05).epsilon(rounding));
  // Of n samples each sees 1 / sqrt(n), of up to 64.
  const std::tuple<std::uint32_t, std::uint32_t, float> parts[]{
      {0, 0, 1}, {1, 3, 0.5f}, {4, 15, 0.25f}, {16, 63, 0.125f}, {64, 0xffffffff, 0.125f}};
  for (const auto& [first, last, part] : parts) {
    CHECK(part_of_pixel(first) == part);
    CHECK(part_of_pixel(last) == part);
  }
  CHECK(one.part(0.25f).spread == Approx(0.0025).epsilon(rounding));
  // Oblong pixels, as wide as a square of their area.
  CHECK(pixel_cone(wide_camera(), 160, 20).spread == Approx(0.02).epsilon(rounding));
  Camera parallel = wide_camera();
  parallel.projection = Projection::orthographic;
  const RayCone box = pixel_cone(parallel, 160, 80);
  CHECK(box.at(0).width == Approx(0.01).epsilon(rounding));
  CHECK(box.at(1000).width == box.width);
  CHECK(box.part(0.5f).width == 0.5f * box.width);
}

TEST_CASE("a surface widens a cone by a quarter of the root of the solid angle that a direction stands for") {
  const RayCone before{0.5f, 0.01f};
  CHECK(before.scattered(25).spread == Approx(0.01 + 0.25 / 5).epsilon(rounding));
  CHECK(before.scattered(25).width == before.width);
  CHECK(before.scattered(1e-20f).spread == Approx(1.01).epsilon(rounding));
}

TEST_CASE("a footprint by second texture coordinates is theirs, and that of the first where there are none") {
  const Geometry one_set = rectangle(1, 4);
  CHECK(footprint(one_set, 0.1f, {0, 0, -1}, CoordinateSet::second) == footprint(one_set, 0.1f, {0, 0, -1}));
  Mesh mesh = *one_set.mesh(0);
  mesh.second_uvs = {{0, 0}, {4, 0}, {4, 16}, {0, 16}};
  mesh.second_uv_indices = mesh.triangles;
  const Geometry two_sets({mesh});
  CHECK(footprint(two_sets, 0.1f, {0, 0, -1}, CoordinateSet::second) == Approx(0.2).epsilon(rounding));
  CHECK(footprint(two_sets, 0.1f, {0, 0, -1}) == Approx(0.05).epsilon(rounding));
}

TEST_CASE("a footprint is what a cone covers of a surface's texture coordinates") {
  // Coordinates to (1, 4): half a unit of them for each unit of length, in both directions.
  CHECK(footprint(rectangle(1, 4), 0.1f, {0, 0, -1}) == Approx(0.05).epsilon(rounding));
  CHECK(footprint(rectangle(1, 4), 0.1f, {0, 0, 7}) == Approx(0.05).epsilon(rounding));
  // To (1, 1): 1/2 and 1/8, on the average (of the areas) 1/4.
  CHECK(footprint(rectangle(1, 1), 0.1f, {0, 0, -1}) == Approx(0.025).epsilon(rounding));
  // At an angle the section is longer by 1 / cos, and as wide as before.
  CHECK(footprint(rectangle(1, 4), 0.1f, {0, 3, -4}) == Approx(0.05 / std::sqrt(0.8)).epsilon(rounding));
  // A mesh without coordinates has the weights of the corners: 1 of them to the triangle's two legs.
  CHECK(footprint(rectangle(0, 0), 0.1f, {0, 0, -1}) == Approx(0.025).epsilon(rounding));
  // From the side, the footprint is wide, and finite.
  CHECK(std::isfinite(footprint(rectangle(1, 4), 0.1f, {0, 1, 0})));
  CHECK(footprint(rectangle(1, 4), 0, {0, 3, -4}) == 0);
  // A sphere of the area 4 pi 9 has the unit square.
  const Geometry ball({SphereSet{"ball", {{{0, 0, 0}, 3}}}});
  CHECK(footprint(ball, 0.1f, surface_at(ball, {1, 0.3f, 0.3f, 0, 0}).geometric_normal) ==
        Approx(0.1 / std::sqrt(4 * M_PI * 9)).epsilon(rounding));
}

}  // namespace twinray::test
