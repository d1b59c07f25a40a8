// SPDX-License-Identifier: Apache-2.0
#include "core/tangents.h"

#include "core/octahedron.h"
#include "tests/support/catch.h"
#include "tests/support/shapes.h"

namespace twinray::test {

TEST_CASE("a triangle's tangents lead from corner to corner as its texture coordinates do") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    Mesh mesh;
    add_triangle(mesh, random.in_ball(), random.in_ball(), random.in_ball());
    for (int corner = 0; corner < 3; ++corner) mesh.uvs.push_back({random.unit(), random.unit()});
    mesh.uv_indices = mesh.triangles;
    const Geometry geometry({mesh});
    const auto tangents = tangents_at(geometry, surface_at(geometry, {.t = 1, .u = 0.2f, .v = 0.3f}));
    REQUIRE(tangents);
    for (std::size_t corner = 1; corner < 3; ++corner) {
      const Vec3 edge = mesh.positions[corner] - mesh.positions[0];
      const Vec3 u = tangents->du * (mesh.uvs[corner].x - mesh.uvs[0].x);
      const Vec3 v = tangents->dv * (mesh.uvs[corner].y - mesh.uvs[0].y);
      CHECK(length(u + v - edge) <= 1e-5f * (length(u) + length(v)));
    }
  }
}

TEST_CASE("a sphere's tangents are the derivatives of its octahedral coordinates") {
  const Sphere sphere{{1, 2, 3}, 2.5f};
  const Geometry geometry({SphereSet{"ball", {sphere}}});
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const float u = 0.01f + 0.98f * random.unit(), v = 0.01f + 0.98f * random.unit();
    const float x = std::fabs(2 * u - 1), y = std::fabs(2 * v - 1);
    if (x < 0.02f || y < 0.02f || std::fabs(x + y - 1) < 0.02f) continue;  // Beside the folds.
    const auto tangents = tangents_at(geometry, surface_at(geometry, {.t = 1, .u = u, .v = v}));
    REQUIRE(tangents);
    constexpr float h = 0x1p-9f;
    const auto slope = [&](float du, float dv) {
      return (octahedral_decode(u + du, v + dv) - octahedral_decode(u - du, v - dv)) *
             (sphere.radius / (2 * h));
    };
    CHECK(length(tangents->du - slope(h, 0)) < 1e-3f * length(tangents->du));
    CHECK(length(tangents->dv - slope(0, h)) < 1e-3f * length(tangents->dv));
  }
}

TEST_CASE("there are no tangents without coordinates, nor of coordinates on a line") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto has_tangents = [](const Mesh& m) {
    const Geometry geometry({m});
    return tangents_at(geometry, surface_at(geometry, {.t = 1, .u = 0.2f, .v = 0.3f})).has_value();
  };
  CHECK_FALSE(has_tangents(mesh));
  mesh.uv_indices = mesh.triangles;
  mesh.uvs = {{0, 0}, {1, 1}, {2, 2}};
  CHECK_FALSE(has_tangents(mesh));
  mesh.uvs = {{0, 0}, {1, 1}, {2, 1}};
  CHECK(has_tangents(mesh));
  mesh.uvs = {{0, 0}, {1e38f, 1}, {2, 1e38f}};
  CHECK_FALSE(has_tangents(mesh));
}

}  // namespace twinray::test
