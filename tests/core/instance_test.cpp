// SPDX-License-Identifier: Apache-2.0
#include "core/instance.h"

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/ray_cone.h"
#include "core/surface.h"
#include "core/tangents.h"
#include "tests/support/catch.h"
#include "tests/support/instances.h"
#include "tests/support/meshes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// A geometry of these instances of a unit box.
Geometry geometry_of(std::vector<Instance> instances) {
  return Geometry({box_mesh()}, nullptr, {{{0, 1}}, std::move(instances)});
}

std::string error_of(std::vector<Instance> instances) {
  try {
    geometry_of(std::move(instances));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string error_of_prototypes(std::vector<ShapeRange> prototypes) {
  try {
    Geometry({box_mesh(), box_mesh(), box_mesh()}, nullptr, {std::move(prototypes), {}});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A mesh of one triangle with texture coordinates and normals that are not its own.
Mesh textured_triangle() {
  Mesh mesh{.name = "triangle", .positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 1}}, .triangles = {{0, 1, 2}}};
  mesh.uvs = {{0, 0}, {1, 0.25f}, {0.5f, 2}};
  mesh.uv_indices = {{0, 1, 2}};
  mesh.normals = {normalize(Vec3{0.1f, 0, 1}), normalize(Vec3{0, 0.2f, 1}), normalize(Vec3{-0.1f, 0.3f, 1})};
  mesh.normal_indices = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("an inverse undoes its transform, of needles and plates, too") {
  Random random(1);
  for (const double squash : {1.0, 1e-3, 1e-6})
    for (const bool is_needle : {false, true})
      for (int i = 0; i < 50; ++i) {
        const Transform t = turned(random) * Transform::scaling(1, squash, is_needle ? squash : 1) *
                            turned(random) * Transform::translation(3, 4, 5);
        const Transform product = t * t.inverse();
        for (int row = 0; row < 3; ++row)
          for (int column = 0; column < 4; ++column)
            REQUIRE(std::fabs(product.m[row][column] - (row == column ? 1 : 0)) <= 0x1p-46 / squash);
      }
}

TEST_CASE("transforms that instances cannot have are refused, and the instance is named") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Transform flat = Transform::scaling(1, 0, 1), thin = Transform::scaling(1, 1e-7, 1);
  const std::string flattens =
      ": its transform flattens; it may stretch no direction more than 1.04858e+06 times as much as another "
      "one";
  CHECK(error_of({{0, {}}, {0, flat}}) == "instance 1" + flattens);
  CHECK(error_of({{0, thin}}) == "instance 0" + flattens);
  CHECK(error_of({{0, Transform::translation(nan, 0, 0)}}) == "instance 0: its transform is not finite");
  CHECK(error_of({{0, Transform::scaling(1e11, 1e11, 1e11)}}) ==
        "instance 0: its transform scales by 1e+11; scales must lie between 1.45519e-11 and 6.87195e+10");
  CHECK(error_of({{0, Transform::scaling(1e-11, 1e-11, 1e-11)}}) ==
        "instance 0: its transform scales by 1e-11; scales must lie between 1.45519e-11 and 6.87195e+10");
  CHECK(error_of({{0, Transform::translation(0, 2e12, 0)}}) ==
        "instance 0: it reaches to 2e+12; coordinates must be within +-1e+12");
  CHECK(error_of({{3, {}}}) == "instance 0 is one of prototype 3; there are 1");
  std::vector<Instance> many(5000);
  many[4000].prototype = many[2500].prototype = 7;
  for (int i = 0; i < 20; ++i)  // The first one, whichever is seen first.
    CHECK(error_of(many) == "instance 2500 is one of prototype 7; there are 1");
  CHECK(can_place(Transform::scaling(-1e10, 1e10, 1e5)));
  for (const Transform& bad : {flat, thin, Transform::scaling(1e11, 1e11, 1e11)}) CHECK_FALSE(can_place(bad));
}

TEST_CASE("prototypes follow each other to the last shape") {
  CHECK(error_of_prototypes({{1, 1}, {2, 1}}).empty());
  CHECK(error_of_prototypes({{0, 0}, {0, 3}}).empty());
  CHECK(error_of_prototypes({{1, 1}}) == "the prototypes end before shape 2; there are 3 shapes");
  CHECK(error_of_prototypes({{0, 1}, {2, 1}}) == "prototype 1 begins with shape 2; it must begin with 1");
  CHECK(error_of_prototypes({{1, 5}}) == "the prototypes end before shape 6; there are 3 shapes");
}

TEST_CASE("a geometry counts and bounds what instances show") {
  const Geometry geometry(
      {box_mesh(), box_mesh(), icosphere_mesh(0)}, nullptr,
      {{{1, 1}, {2, 1}}, {{0, Transform::translation(10, 0, 0)}, {0, Transform::scaling(2, 2, 2)}}});
  const std::size_t box = box_mesh().triangles.size();
  CHECK(geometry.primitive_count() == 2 * box + icosphere_mesh(0).triangles.size());
  CHECK(geometry.seen_primitives() == 3 * box);
  CHECK(geometry.direct_shapes() == ShapeRange{0, 1});
  const Aabb own = Geometry({box_mesh()}).bounds();
  CHECK(geometry.bounds().upper.x >= own.upper.x + 10);
  CHECK(geometry.bounds().upper.x <= (own.upper.x + 10) * 1.000001f);
  CHECK(geometry.bounds().upper.y >= own.upper.y * 2);
}

TEST_CASE("a point of an instance is that of a copy: normals, tangents, texture coordinates and footprint") {
  constexpr float rounding = 1e-5f;
  Random random(7);
  for (const Kind kind : {Kind::rigid, Kind::scaled, Kind::sheared}) {
    const Transform to_world = transform_of(kind, random);
    const Geometry geometry({textured_triangle()}, nullptr, {{{0, 1}}, {{0, to_world}}});
    const Geometry copy({copied(textured_triangle(), to_world)});
    const Hit hit{.t = 1, .u = 0.3f, .v = 0.4f, .primitive = 0, .mesh = 0, .instance = 0};
    Hit of_copy = hit;
    of_copy.instance = no_instance;
    const SurfacePoint p = surface_at(geometry, hit), q = surface_at(copy, of_copy);
    CHECK(length(p.position - q.position) <= rounding);
    CHECK(length(p.geometric_normal - q.geometric_normal) <= rounding);
    CHECK(length(p.shading_normal - q.shading_normal) <= rounding);
    CHECK(dot(p.shading_normal, p.geometric_normal) > 0);
    CHECK(p.offset >= 0.25f * q.offset);
    CHECK(p.offset <= 20 * q.offset);
    const auto own = tangents_at(geometry, p), other = tangents_at(copy, q);
    REQUIRE(own.has_value());
    CHECK(length(own->du - other->du) <= rounding * length(other->du));
    CHECK(length(own->dv - other->dv) <= rounding * length(other->dv));
    const Vec3 direction = normalize(Vec3{0.2f, -1, 0.4f});
    CHECK(texture_footprint(geometry, hit, p, 0.1f, direction) ==
          Approx(texture_footprint(copy, of_copy, q, 0.1f, direction)).epsilon(1e-4));
    CHECK(length(mixed_normal(geometry, hit) - mixed_normal(copy, of_copy)) <= rounding);
  }
}

TEST_CASE("a sphere of an instance is an ellipsoid whose normals point outward, mirrored or not") {
  const SphereSet set{.name = "ball", .spheres = {{{0, 0, 0}, 1}}};
  for (const double side : {1.0, -1.0}) {
    const Geometry geometry({set}, nullptr, {{{0, 1}}, {{0, Transform::scaling(side * 2, 1, 0.5)}}});
    Random random(9);
    for (int i = 0; i < 100; ++i) {
      const Hit hit{.t = 1, .u = random.unit(), .v = random.unit(), .instance = 0};
      const SurfacePoint point = surface_at(geometry, hit);
      const Vec3 own{point.position.x / 2, point.position.y, point.position.z * 2};
      CHECK(length(own) == Approx(1).epsilon(1e-5));
      CHECK(dot(point.geometric_normal, normalize(Vec3{own.x / 2, own.y, own.z * 2})) > 0.99999f);
      if (const auto tangents = tangents_at(geometry, point))
        CHECK(std::fabs(dot(normalize(tangents->du), point.geometric_normal)) < 1e-4f);
    }
  }
}
