// SPDX-License-Identifier: Apache-2.0
#include "core/loop_subdivision.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/meshes.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

Mesh divided(const Mesh& control, int levels) {
  auto made = loop_subdivided(control, levels);
  REQUIRE(made);
  return std::move(*made);
}

/// Vertices of three to eight neighbours, nowhere regular.
Mesh bumpy() {
  Mesh mesh = icosphere_mesh(1);
  Random random(5);
  for (Vec3& p : mesh.positions) p = p + random.in_ball() * 0.2f;
  // A vertex of three neighbours in the middle of a triangle, whose corners get one more.
  const auto [a, b, c] = mesh.triangles[0];
  const auto inside = std::uint32_t(mesh.positions.size());
  mesh.positions.push_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) * 0.4f);
  mesh.triangles[0] = {a, b, inside};
  mesh.triangles.push_back({b, c, inside});
  mesh.triangles.push_back({c, a, inside});
  return mesh;
}

/// A square of n x n vertices, one apart, of height f(x, y); diagonals all run one way.
template <typename F>
Mesh sheet(int n, const F& height) {
  Mesh mesh;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) mesh.positions.push_back({float(x), float(y), height(float(x), float(y))});
  for (int y = 0; y + 1 < n; ++y)
    for (int x = 0; x + 1 < n; ++x) {
      const auto a = std::uint32_t(y * n + x), b = a + 1, c = b + std::uint32_t(n), d = a + std::uint32_t(n);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

/// Of a sheet with a bump: vertices at its end have two to six neighbours.
Mesh open_sheet() {
  Random random(9);
  Mesh mesh = sheet(5, [&](float, float) { return random.unit(); });
  // One more triangle beside: at a straight end.
  mesh.positions.push_back({2, -1, 0.3f});
  mesh.triangles.push_back({1, 25, 2});
  mesh.triangles.push_back({2, 25, 3});
  return mesh;
}

std::size_t edge_count(const Mesh& closed) { return closed.triangles.size() * 3 / 2; }

}  // namespace

TEST_CASE("each level has four times the triangles, and a closed surface stays one") {
  for (const int levels : {0, 1, 2, 3}) {
    const Mesh mesh = divided(bumpy(), levels);
    CHECK(double(mesh.triangles.size()) == loop_triangles(bumpy().triangles.size(), levels));
    CHECK(mesh.positions.size() + mesh.triangles.size() == edge_count(mesh) + 2);  // Euler
    CHECK(mesh.normals.size() == mesh.positions.size());
    CHECK(mesh.normal_indices == mesh.triangles);
    CHECK(loop_subdivided(mesh, 0));
  }
}

TEST_CASE("a vertex has the same limit and normal at every level, inside and at the end of a surface") {
  for (const Mesh& control : {bumpy(), open_sheet(), tetrahedron_mesh(), box_mesh()}) {
    const Mesh limit = divided(control, 0);
    for (const int levels : {1, 2, 4}) {
      CAPTURE(control.triangles.size(), levels);
      const Mesh finer = divided(control, levels);
      for (std::size_t i = 0; i < control.positions.size(); ++i) {
        CAPTURE(i);
        CHECK(length(finer.positions[i] - limit.positions[i]) < 1e-5f);
        CHECK(length(finer.normals[i] - limit.normals[i]) < 3e-3f);
      }
    }
  }
}

TEST_CASE("vertices of a regular solid lie on a sphere, and their normals point out of it") {
  for (const Mesh& control : {tetrahedron_mesh(), icosphere_mesh(0)}) {
    const Mesh mesh = divided(control, 0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      CHECK(length(mesh.positions[i]) == Approx(length(mesh.positions[0])));
      CHECK(length(mesh.normals[i] - normalize(mesh.positions[i])) < 1e-5f);
    }
  }
}

TEST_CASE("normals are those of the triangles around, up to their size") {
  const Mesh mesh = divided(bumpy(), 4);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 facet = normalize(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    for (const std::uint32_t i : t) CHECK(dot(facet, mesh.normals[i]) > 0.95f);
  }
}

TEST_CASE("a regular sheet with the heights of a parabola becomes one") {
  constexpr int n = 7;
  const Mesh mesh = divided(sheet(n, [](float x, float) { return x * x / 8; }), 3);
  const float raised = mesh.positions[3 * n + 3].z - 9.0f / 8;
  for (int y = 2; y < n - 2; ++y)
    for (int x = 2; x < n - 2; ++x) {
      const auto i = std::size_t(y * n + x);
      CHECK(length(mesh.positions[i] - Vec3{float(x), float(y), float(x * x) / 8 + raised}) < 1e-5f);
      CHECK(length(mesh.normals[i] - normalize({-float(x) / 4, 0, 1})) < 1e-3f);
    }
}

TEST_CASE("a flat sheet stays flat, with the normals of its front, and its straight ends stay straight") {
  const Mesh mesh = divided(sheet(5, [](float, float) { return 2.0f; }), 2);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    CHECK(mesh.positions[i].z == Approx(2));
    CHECK(length(mesh.normals[i] - Vec3{0, 0, 1}) < 1e-5f);
  }
  CHECK(length(mesh.positions[2] - Vec3{2, 0, 2}) < 1e-5f);
  // The corner of a cubic B-spline: a sixth of either neighbour.
  CHECK(length(mesh.positions[0] - Vec3{1.0f / 6, 1.0f / 6, 2}) < 1e-5f);
}

TEST_CASE("a mesh that is no surface is not divided") {
  const std::vector<Vec3> positions{{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                    {0, -1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const auto refused = [&](std::vector<Triangle> triangles) {
    Mesh mesh;
    mesh.positions = positions;
    mesh.triangles = std::move(triangles);
    return !loop_subdivided(mesh, 1);
  };
  CHECK_FALSE(refused({{0, 1, 2}, {1, 0, 3}}));
  CHECK(refused({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));  // Three at an edge.
  CHECK(refused({{0, 1, 2}, {0, 1, 3}}));             // One of them the other way round.
  CHECK(refused({{0, 1, 1}}));
  CHECK(refused({{0, 1, 2}, {0, 5, 6}}));  // They share a corner alone.
  const Mesh tip = tetrahedron_mesh();
  Mesh both = tip;  // Two closed surfaces that touch at a vertex.
  for (const Vec3& p : tip.positions) both.positions.push_back(p * 2 - tip.positions[0]);
  for (const Triangle& t : tip.triangles) {
    Triangle moved;
    for (std::size_t k = 0; k < 3; ++k) moved[k] = t[k] == 0 ? 0 : t[k] + 4;
    both.triangles.push_back(moved);
  }
  CHECK_FALSE(loop_subdivided(both, 1));
}

TEST_CASE("vertices without triangles stay where they are") {
  Mesh mesh = tetrahedron_mesh();
  mesh.positions.push_back({5, 6, 7});
  const Mesh divided_mesh = divided(mesh, 2);
  CHECK(divided_mesh.positions[4] == Vec3{5, 6, 7});
  CHECK(divided(Mesh{}, 2).triangles.empty());
}

}  // namespace twinray::test
