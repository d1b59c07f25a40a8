// SPDX-License-Identifier: Apache-2.0
#include "check/placement.h"

#include "tests/support/catch.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr double float_rounding = 1e-6;  // A few roundings of float.

/// A triangle and a sphere in a box of 8 x 4 x 2 around (1, 0, 0).
std::shared_ptr<const Geometry> small() {
  Mesh mesh{.name = "mesh"};
  add_triangle(mesh, {-3, -2, -1}, {5, -2, -1}, {-3, 2, 1});
  return share({mesh, SphereSet{"balls", {{{4, 0, 0.5f}, 0.5f}}}});
}

const Vec3& corner(const Geometry& geometry, int index) {
  return geometry.mesh(0)->positions[std::size_t(index)];
}
const Sphere& ball(const Geometry& geometry) { return geometry.sphere_set(1)->spheres[0]; }

void check_near(const Vec3& found, const Vec3& expected) {
  for (int axis = 0; axis < 3; ++axis)
    CHECK(found[axis] == Approx(expected[axis]).epsilon(float_rounding).margin(1e-30));
}

/// All of `small()` times a factor, radii too.
void check_scaled(Placement placement, float factor) {
  const auto placed = placed_geometry(small(), placement);
  for (int i = 0; i < 3; ++i) check_near(corner(*placed, i), corner(*small(), i) * factor);
  check_near(ball(*placed).center, ball(*small()).center * factor);
  CHECK(ball(*placed).radius == Approx(ball(*small()).radius * factor).epsilon(float_rounding));
}

}  // namespace

TEST_CASE("a shrunk scene is a millionth of its size, radii included") {
  check_scaled(Placement::shrunk, 1e-6f);
}

TEST_CASE("a grown scene is a million times its size, radii included") {
  check_scaled(Placement::grown, 1e6f);
}

TEST_CASE("a moved scene keeps its size and lies 10^5 sizes away") {
  const auto placed = placed_geometry(small(), Placement::moved);
  CHECK(ball(*placed).radius == 0.5f);
  CHECK(placed->bounds().center().x == Approx(0.74 * 8e5).epsilon(1e-4));
  CHECK(placed->bounds().center().y == Approx(-0.31 * 8e5).epsilon(1e-4));
  CHECK(placed->bounds().center().z == Approx(0.89 * 8e5).epsilon(1e-4));
  // Coordinates of 7e5 are multiples of 1/16.
  check_near(ball(*placed).center - corner(*placed, 0), ball(*small()).center - corner(*small(), 0));
}

TEST_CASE("instances are placed as all else is, and their prototypes stay as they are") {
  const auto plain = small();
  const auto geometry = std::make_shared<const Geometry>(
      plain->shapes(), nullptr, Instancing{{{1, 1}}, {{0, Transform::translation(1, 2, 3)}}});
  const auto grown = placed_geometry(geometry, Placement::grown);
  check_near(corner(*grown, 1), corner(*geometry, 1) * 1e6f);
  CHECK(ball(*grown).radius == 0.5f);
  check_near(grown->instances()[0].to_world.point({4, 0, 0.5f}), Vec3{5, 2, 3.5f} * 1e6f);
  CHECK(grown->prototypes() == geometry->prototypes());
}

TEST_CASE("no placement leaves the range of coordinates") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {5e9f, 0, 0}, {0, 5e9f, 0});
  const auto grown = placed_geometry(share({mesh}), Placement::grown);
  CHECK(max_abs(grown->bounds().upper) == Approx(5e11).epsilon(float_rounding));
  const auto moved = placed_geometry(share({mesh}), Placement::moved);
  CHECK(max_abs(moved->bounds().upper) > 4e11f);
  CHECK(max_abs(moved->bounds().upper) <= max_coordinate);
}

TEST_CASE("the file's placement is the geometry itself, and nothing stays nothing") {
  const auto geometry = small();
  CHECK(placed_geometry(geometry, Placement::file) == geometry);
  CHECK(placed_geometry(share({}), Placement::grown)->primitive_count() == 0);
}

TEST_CASE("triangles that lose their area when they are moved are dropped") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  add_triangle(mesh, {0, 0, 0}, {1e-4f, 0, 0}, {0, 1e-4f, 0});
  CHECK(placed_geometry(share({mesh}), Placement::moved)->primitive_count() == 1);
}
