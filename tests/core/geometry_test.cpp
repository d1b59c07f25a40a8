// SPDX-License-Identifier: Apache-2.0
#include "core/geometry.h"

#include "core/error.h"
#include "core/offset.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

Mesh corner() {
  return {.name = "corner", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
}

std::string message_of(std::vector<Shape> shapes) {
  try {
    const Geometry geometry(std::move(shapes));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a geometry counts its primitives and knows their box") {
  const Geometry geometry({corner(), SphereSet{.name = "", .spheres = {{{4, 5, 6}, 2}, {{0, 0, 0}, 0}}}});
  CHECK(geometry.triangle_count() == 1);
  CHECK(geometry.sphere_count() == 2);
  CHECK(geometry.primitive_count() == 3);
  CHECK(geometry.mesh(0)->name == "corner");
  CHECK(geometry.mesh(1) == nullptr);
  CHECK(geometry.sphere_set(0) == nullptr);
  CHECK(geometry.sphere_set(1)->spheres.size() == 2);
  CHECK(geometry.bounds().contains(Aabb{{0, 0, 0}, {6, 7, 8}}));
  CHECK(geometry.bounds().upper.x == std::nextafter(6.0f, Aabb::infinity));
}

TEST_CASE("a triangle's facet is its unit normal and its offset") {
  const Geometry geometry({SphereSet{.name = "", .spheres = {{{4, 5, 6}, 2}}}, corner()});
  CHECK(geometry.facet(1, 0).normal == Vec3{0, 0, 1});
  CHECK(geometry.facet(1, 0).offset == triangle_offset({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

TEST_CASE("an empty geometry is legal and has an empty box") {
  CHECK(Geometry().bounds().is_empty());
  CHECK(Geometry(std::vector<Shape>{}).primitive_count() == 0);
  CHECK(Geometry({Mesh{}, SphereSet{}}).bounds().is_empty());
}

TEST_CASE("vertices that no triangle uses do not widen the box") {
  Mesh mesh = corner();
  mesh.positions.push_back({100, 100, 100});
  CHECK(Geometry({mesh}).bounds() == Aabb{{0, 0, 0}, {1, 1, 0}});
}

TEST_CASE("a vertex index out of range is named") {
  Mesh mesh = corner();
  mesh.triangles.push_back({0, 1, 3});
  CHECK(message_of({mesh}) == "shape 0 \"corner\": triangle 1 names vertex 3; there are 3");
}

TEST_CASE("a coordinate that is not finite or too large is named") {
  Mesh mesh = corner();
  mesh.positions[2].y = Aabb::infinity;
  CHECK(message_of({SphereSet{}, mesh}) ==
        "shape 1 \"corner\": vertex 2 is (0, inf, 0); coordinates must be finite and within +-1e+12");
  mesh.positions[2].y = 2e12f;
  CHECK(
      message_of({mesh}) ==
      "shape 0 \"corner\": vertex 2 is (0, 2000000000000, 0); coordinates must be finite and within +-1e+12");
  mesh.positions[2].y = -1e12f;
  CHECK(message_of({mesh}).empty());
  mesh.positions[1].x = std::numeric_limits<float>::quiet_NaN();
  CHECK(message_of({mesh}) ==
        "shape 0 \"corner\": vertex 1 is (nan, 0, 0); coordinates must be finite and within +-1e+12");
}

TEST_CASE("normals and uvs that do not match the triangles are named") {
  Mesh mesh = corner();
  mesh.normals = {{0, 0, 1}};
  CHECK(message_of({mesh}) == "shape 0 \"corner\": 1 triangles but 0 triples of normal indices");
  mesh.normal_indices = {{0, 0, 1}};
  CHECK(message_of({mesh}) == "shape 0 \"corner\": triangle 0 names normal 1; there are 1");
  mesh.normal_indices = {{0, 0, 0}};
  CHECK(message_of({mesh}).empty());
  mesh.uv_indices = {{0, 0, 0}};
  CHECK(message_of({mesh}) == "shape 0 \"corner\": triangle 0 names uv 0; there are 0");
  mesh.uv_indices.clear();
  mesh.second_uvs = {{0, 0}};
  CHECK(message_of({mesh}) == "shape 0 \"corner\": 1 triangles but 0 triples of second uv indices");
}

TEST_CASE("a sphere's centre and radius out of range are named") {
  CHECK(message_of({SphereSet{.spheres = {{}, {{0, 0, 0}, -1}}}}) ==
        "shape 0: the radius of sphere 1 is -1; it must lie in [0, 1e+12]");
  CHECK(message_of({SphereSet{.spheres = {{{0, 0, 0}, Aabb::infinity}}}}) ==
        "shape 0: the radius of sphere 0 is inf; it must lie in [0, 1e+12]");
  CHECK(message_of({SphereSet{.name = "drops", .spheres = {{{0, Aabb::infinity, 0}, 1}}}}) ==
        "shape 0 \"drops\": the centre of sphere 0 is (0, inf, 0); coordinates must be finite and within "
        "+-1e+12");
}

TEST_CASE("degenerate triangles are dropped, and the attributes stay in step") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, Aabb::infinity, 0}};
  mesh.triangles = {{0, 1, 1}, {0, 1, 2}, {0, 1, 3}, {1, 3, 2}, {0, 1, 4}};
  mesh.normals = {{0, 0, 1}};
  mesh.normal_indices = {{10, 0, 0}, {11, 0, 0}, {12, 0, 0}, {13, 0, 0}, {14, 0, 0}};
  mesh.uvs = {{0, 0}};
  mesh.uv_indices = {{20, 0, 0}, {21, 0, 0}, {22, 0, 0}, {23, 0, 0}, {24, 0, 0}};
  mesh.second_uvs = {{0, 0}};
  mesh.second_uv_indices = {{30, 0, 0}, {31, 0, 0}, {32, 0, 0}, {33, 0, 0}, {34, 0, 0}};
  CHECK(drop_degenerate_triangles(mesh) == 3);
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
  CHECK(mesh.normal_indices == std::vector<Triangle>{{11, 0, 0}, {13, 0, 0}});
  CHECK(mesh.uv_indices == std::vector<Triangle>{{21, 0, 0}, {23, 0, 0}});
  CHECK(mesh.second_uv_indices == std::vector<Triangle>{{31, 0, 0}, {33, 0, 0}});
  CHECK(drop_degenerate_triangles(mesh) == 0);
}

TEST_CASE("the smallest of triangles has area, however far from the origin of space") {
  Mesh mesh = corner();
  mesh.positions = {{1e6f, 1e6f, 0},
                    {std::nextafter(1e6f, Aabb::infinity), 1e6f, 0},
                    {1e6f, std::nextafter(1e6f, Aabb::infinity), 0}};
  CHECK(drop_degenerate_triangles(mesh) == 0);
  mesh.positions = {{0, 0, 0}, {0x1p-149f, 0, 0}, {0, 0x1p-149f, 0}};
  CHECK(drop_degenerate_triangles(mesh) == 0);
}

TEST_CASE("the box of a sphere has the next floats beside those that its radius gives") {
  const float values[] = {0, 0x1p-149f, 0x1p-126f, 1, 0x1.fffffep0f, 2, 1e12f, 0x1.fffffep127f};
  for (const float radius : values)
    for (const float size : values)
      for (const float center : {size, -size}) {
        const Aabb box = sphere_bounds({{center, center, center}, radius});
        CHECK(box.lower.y == std::nextafter(center - radius, -Aabb::infinity));
        CHECK(box.upper.y == std::nextafter(center + radius, Aabb::infinity));
      }
}

TEST_CASE("a sphere's box holds its rounded extent") {
  const Aabb box = sphere_bounds({{0x1.000002p0f, -1, 0}, 0x1p-30f});
  CHECK(box.lower.x < 0x1.000002p0f);
  CHECK(box.upper.x > 0x1.000002p0f);
  CHECK(box.lower.z < -0x1p-30f);
  CHECK(box.upper.z > 0x1p-30f);
}

}  // namespace twinray
