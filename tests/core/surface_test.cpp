// SPDX-License-Identifier: Apache-2.0
#include "core/surface.h"

#include "core/octahedron.h"
#include "core/offset.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"

namespace twinray {
namespace {

using test::Random;

Geometry single(const test::Corners& corners) {
  return Geometry({Mesh{.positions = {corners[0], corners[1], corners[2]}, .triangles = {{0, 1, 2}}}});
}

Geometry attributed() {
  Mesh mesh{.name = "attributed", .positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, .triangles = {{0, 1, 2}}};
  mesh.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, -0.8f}};
  mesh.normal_indices = {{0, 1, 2}};
  mesh.uvs = {{0, 0}, {2, 0}, {0, 8}};
  mesh.uv_indices = {{0, 1, 2}};
  mesh.second_uvs = {{1, 0}, {0, 4}};
  mesh.second_uv_indices = {{1, 0, 0}};
  return Geometry({mesh});
}

/// The heights of p over the three edges, within the triangle's plane; in double.
double least_height(const test::Corners& v, const Vec3& p) {
  double least = 1e300;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = v[i], &b = v[(i + 1) % 3], &c = v[(i + 2) % 3];
    const double e[3] = {double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z};
    const double f[3] = {double(c.x) - a.x, double(c.y) - a.y, double(c.z) - a.z};
    const double g[3] = {double(p.x) - a.x, double(p.y) - a.y, double(p.z) - a.z};
    const double ee = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
    const double ef = (e[0] * f[0] + e[1] * f[1] + e[2] * f[2]) / ee;
    const double eg = (e[0] * g[0] + e[1] * g[1] + e[2] * g[2]) / ee;
    double up = 0, height = 0;
    for (int k = 0; k < 3; ++k) up += (f[k] - ef * e[k]) * (f[k] - ef * e[k]);
    for (int k = 0; k < 3; ++k) height += (g[k] - eg * e[k]) * (f[k] - ef * e[k]);
    least = std::min(least, height / std::sqrt(up));
  }
  return least;
}

}  // namespace

TEST_CASE("a triangle's point has the weights' position, normal and uv") {
  const SurfacePoint point = surface_at(attributed(), {.t = 1, .u = 0.25f, .v = 0.5f});
  CHECK(point.position == Vec3{1, 2, 0});
  CHECK(point.geometric_normal == Vec3{0, 0, 1});
  CHECK(point.uv == Vec2{0.5f, 4});
  CHECK(point.second_uv == Vec2{0.75f, 1});
  CHECK(point.offset == triangle_offset({0, 0, 0}, {4, 0, 0}, {0, 4, 0}));
  CHECK(length(point.shading_normal) == Approx(1).epsilon(1e-6));
  const Vec3 expected = normalize(Vec3{0.15f, 0.3f, 0.05f});
  CHECK(length(point.shading_normal - expected) < 1e-6f);
}

TEST_CASE("a mixed normal has the length that the mixture has") {
  const Vec3 mixed = mixed_normal(attributed(), {.t = 1, .u = 0.25f, .v = 0.5f});
  CHECK(length(mixed - Vec3{0.15f, 0.3f, 0.05f}) < 1e-6f);
  CHECK(mixed_normal(single({Vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}), {.t = 1, .u = 0.1f, .v = 0.1f}) ==
        Vec3{0, 0, 1});
  const Geometry ball({SphereSet{"ball", {{{1, 2, 3}, 2}}}});
  CHECK(length(mixed_normal(ball, {.t = 1, .u = 0.25f, .v = 0.5f})) == Approx(1).epsilon(1e-6));
}

TEST_CASE("a shading normal is the file's, on whichever side that has it") {
  const SurfacePoint point = surface_at(attributed(), {.t = 1, .u = 0.05f, .v = 0.9f});
  CHECK(length(point.shading_normal - normalize(Vec3{0.03f, 0.54f, -0.63f})) < 1e-6f);
  CHECK(point.geometric_normal == Vec3{0, 0, 1});
}

TEST_CASE("without normals and uvs a point has the geometric normal and the weights") {
  const SurfacePoint point =
      surface_at(single({Vec3{0, 0, 0}, {0, 2, 0}, {0, 0, 2}}), {.t = 1, .u = 0.5f, .v = 0.25f});
  CHECK(point.shading_normal == Vec3{1, 0, 0});
  CHECK(point.uv == Vec2{0.5f, 0.25f});
  CHECK(point.second_uv == point.uv);
}

TEST_CASE("normals that cancel leave the geometric one") {
  Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  mesh.normals = {{1, 0, 0}, {-1, 0, 0}};
  mesh.normal_indices = {{0, 1, 0}};
  CHECK(surface_at(Geometry({mesh}), {.t = 1, .u = 0.5f, .v = 0.25f}).shading_normal == Vec3{0, 0, 1});
}

TEST_CASE("a triangle of 10^-18 has a unit normal") {
  const SurfacePoint point =
      triangle_point(single({Vec3{0, 0, 0}, {1e-18f, 0, 0}, {0, 1e-18f, 0}}), 0, 0, 0, 0);
  CHECK(point.geometric_normal == Vec3{0, 0, 1});
}

TEST_CASE("a point near an edge keeps eight offsets from it where the triangle has room") {
  Random random(21);
  // What the rounding of the position, 4 u of each component, may take away again, as a part of the offset of
  // 10 u.
  const double rounding = 0.7;
  int roomy = 0;
  for (int i = 0; i < 100000; ++i) {
    const test::Corners v = test::hostile_triangle(random);
    Mesh mesh{.positions = {v[0], v[1], v[2]}, .triangles = {{0, 1, 2}}};
    if (drop_degenerate_triangles(mesh) != 0) continue;
    const Vec3 centre = (v[0] + v[1] + v[2]) * (1 / 3.0f);
    const float u = random.below(3) == 0 ? 0 : random.unit();
    const float w = random.below(3) == 0 ? 0 : random.unit() * (1 - u);
    const SurfacePoint point = triangle_point(Geometry({mesh}), 0, 0, u, w);
    // The height of the centre is a third of the least height; beyond 64 times the move it is not limited.
    if (least_height(v, centre) * 3 < 8.0 * point.offset * 80) continue;
    ++roomy;
    INFO("draw " << i << " u " << u << " w " << w);
    CHECK(least_height(v, point.position) > (8 / 1.05 - rounding) * point.offset);
  }
  CHECK(roomy > 30000);
}

TEST_CASE("a point stays within the box of its triangle") {
  Random random(22);
  for (int i = 0; i < 100000; ++i) {
    const test::Corners v = test::hostile_triangle(random);
    Mesh mesh{.positions = {v[0], v[1], v[2]}, .triangles = {{0, 1, 2}}};
    if (drop_degenerate_triangles(mesh) != 0) continue;
    const float u = random.unit();
    const Vec3 p = triangle_point(Geometry({mesh}), 0, 0, u, 1 - u).position;
    CHECK(triangle_bounds(v[0], v[1], v[2]).contains(Aabb{p, p}));
  }
}

TEST_CASE("a sphere's point has the octahedral normal of its hit") {
  const Geometry geometry({SphereSet{.spheres = {{{1, 2, 3}, 1}, {{5, 0, 0}, 2}}}});
  const Vec2 uv = octahedral_encode(0, 3, 0);
  const SurfacePoint point = surface_at(geometry, {.t = 1, .u = uv.x, .v = uv.y, .primitive = 1});
  CHECK(point.position == Vec3{5, 2, 0});
  CHECK(point.geometric_normal == Vec3{0, 1, 0});
  CHECK(point.shading_normal == Vec3{0, 1, 0});
  CHECK(point.uv == uv);
  CHECK(point.offset == sphere_offset({5, 0, 0}, 2));
}

}  // namespace twinray
