// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/mesh_area.h"
#include "tests/support/catch.h"

namespace twinray {
namespace {

constexpr double half_turn = 3.14159265358979324;

double area_of_mesh(const Mesh& mesh) {
  double area = 0;
  for (const Triangle& triangle : mesh.triangles) area += area_vector(mesh, triangle).area();
  return area;
}

/// The means of each ring's corners, of which the last one is the first again.
std::vector<Vec3> centers(const Mesh& mesh, std::size_t sides) {
  std::vector<Vec3> means;
  for (std::size_t first = 0; first < mesh.positions.size(); first += sides + 1) {
    Vec3 sum;
    for (std::size_t k = 0; k < sides; ++k) sum += mesh.positions[first + k];
    means.push_back(sum / float(sides));
  }
  return means;
}

/// Whether all triangles face where their shading normals point, which are unit vectors.
bool faces_outward(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 facet = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const std::uint32_t corner : t)
      if (!(dot(facet, mesh.normals[corner]) > 0) || std::fabs(length(mesh.normals[corner]) - 1) > 1e-5f)
        return false;
  }
  return true;
}

const std::vector<Vec3> straight{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
const std::vector<Vec3> spiral{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 1}, {-4, 4, 2}, {-4, 0, 2}, {0, 0, 3}};

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const float t = std::clamp(dot(p - a, along) / length_squared(along), 0.0f, 1.0f);
  return double(length(p - a - along * t));
}

}  // namespace

TEST_CASE("a straight curve is one step, whose area is that of a round tube of its width") {
  for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder}) {
    const std::size_t sides = kind == CurveKind::flat ? 4 : 8;
    const Mesh mesh = curve_mesh({.kind = kind, .points = straight, .width0 = 0.5f, .width1 = 0.5f});
    CHECK(mesh.triangles.size() == 2 * sides);
    CHECK(area_of_mesh(mesh) == Approx(half_turn * 0.5 * 3).epsilon(1e-5));
    CHECK(faces_outward(mesh));
    CHECK(mesh.uvs.front() == Vec2{0, 0});
    CHECK(mesh.uvs.back() == Vec2{1, 1});
  }
}

TEST_CASE("a curve with ends is closed all around") {
  for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder}) {
    const Curve open{.kind = kind, .points = spiral, .width0 = 0.5f, .width1 = 0.2f};
    Curve closed = open;
    closed.has_ends = true;
    const Mesh mesh = curve_mesh(closed);
    const std::size_t sides = kind == CurveKind::flat ? 4 : 8;
    CHECK(mesh.triangles.size() == curve_mesh(open).triangles.size() + 2 * (sides - 2));
    CHECK(faces_outward(mesh));
    // Each edge has a triangle on either side, which go along it in opposite directions.
    std::map<std::array<float, 6>, int> edges;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
        const bool is_forward = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        const Vec3 &low = is_forward ? a : b, &high = is_forward ? b : a;
        edges[{low.x, low.y, low.z, high.x, high.y, high.z}] += is_forward ? 1 : -1;
      }
    CHECK(std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
  }
}

TEST_CASE("a curve becomes thinner along all of it") {
  const Mesh mesh = curve_mesh({.points = straight, .width0 = 1, .width1 = 0});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    CHECK(std::hypot(p.y, p.z) == Approx((1 - p.x / 3) * half_turn / (8 * std::sqrt(0.5))).margin(1e-6));
  }
}

TEST_CASE("steps of a bent curve lie within a fiftieth of its width, or 0.004 of its length") {
  const double outline = 8 + std::sqrt(17.0);
  for (const float width : {3.0f, 1.0f, 0.01f}) {
    const Mesh mesh =
        curve_mesh({.kind = CurveKind::cylinder, .points = spiral, .width0 = width, .width1 = width});
    const std::vector<Vec3> found = centers(mesh, 8);
    CHECK(found.size() == (width == 3 ? 19 : 21));
    CHECK(faces_outward(mesh));
    for (int i = 0; i <= 500; ++i) {
      const float t = float(i) / 500, s = 1 - t;
      const Vec3 p = spiral[0] * (s * s * s) + spiral[1] * (3 * s * s * t) + spiral[2] * (3 * s * t * t) +
                     spiral[3] * (t * t * t);
      double least = 1e9;
      for (std::size_t k = 1; k < found.size(); ++k)
        least = std::min(least, distance_to_segment(p, found[k - 1], found[k]));
      CHECK(least <= std::max(0.02 * double(width), 0.004 * outline) + 1e-5);
    }
  }
}

TEST_CASE("each basis and degree of curves begins, passes and ends where it should") {
  const auto ends = [](CurveBasis basis, int degree, const std::vector<Vec3>& points) {
    const std::vector<Vec3> found = centers(
        curve_mesh({.basis = basis, .degree = degree, .points = points, .width0 = 1e-3f, .width1 = 1e-3f}),
        4);
    return std::pair(found.front(), found.back());
  };
  const auto near = [](const Vec3& a, const Vec3& b) { return length(a - b) < 1e-5f; };
  const std::vector<Vec3> three{{0, 0, 0}, {2, 4, 0}, {4, 0, 0}};
  CHECK(near(ends(CurveBasis::bezier, 2, three).second, {4, 0, 0}));
  CHECK(near(ends(CurveBasis::bezier, 3, spiral).second, {0, 0, 3}));
  CHECK(near(ends(CurveBasis::bspline, 2, three).first, {1, 2, 0}));
  CHECK(near(ends(CurveBasis::bspline, 2, three).second, {3, 2, 0}));
  // A uniform cubic B-spline begins at a sixth of its first point, two thirds of the second and a sixth of
  // the third.
  const std::vector<Vec3> five{{6, 0, 0}, {0, 6, 0}, {0, 0, 6}, {12, 0, 0}, {0, 0, 12}};
  CHECK(near(ends(CurveBasis::bspline, 3, five).first, {1, 4, 1}));
  CHECK(near(ends(CurveBasis::bspline, 3, five).second, {8, 0, 3}));
  const std::vector<Vec3> parabola =
      centers(curve_mesh({.degree = 2, .points = three, .width0 = 1e-3f, .width1 = 1e-3f}), 4);
  for (const Vec3& p : parabola) CHECK(p.y == Approx(p.x * (4 - p.x) / 2).margin(1e-4));
}

TEST_CASE("a ribbon faces its normals, across as wide as it is") {
  const Mesh mesh = curve_mesh({.kind = CurveKind::ribbon,
                                .points = straight,
                                .width0 = 1,
                                .width1 = 0.5f,
                                .normals = {{0, 0, 2}, {0, 0, 2}}});
  CHECK(mesh.positions == std::vector<Vec3>{{0, 0.5f, 0}, {0, -0.5f, 0}, {3, 0.25f, 0}, {3, -0.25f, 0}});
  CHECK(faces_outward(mesh));
  for (const Vec3& normal : mesh.normals) CHECK(normal == Vec3{0, 0, 1});
}

TEST_CASE("curves that stand still, or fold back, are meshes without anything that is not finite") {
  const std::vector<std::vector<Vec3>> all{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                                           {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                                           {{0, 0, 0}, {3, 0, 0}, {-2, 0, 0}, {1, 0, 0}}};
  for (const std::vector<Vec3>& points : all)
    for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder, CurveKind::ribbon}) {
      const Mesh mesh = curve_mesh({.kind = kind, .points = points, .normals = {{0, 0, 1}, {0, 0, 1}}});
      for (const std::vector<Vec3>* const list : {&mesh.positions, &mesh.normals})
        for (const Vec3& v : *list) CHECK(is_finite(v));
    }
}

TEST_CASE("a curve whose lengths overflow is a mesh all the same, which is refused later") {
  for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder}) {
    Curve curve{.kind = kind, .points = straight};
    curve.points[1] = {1e20f, 0.3f, 0};
    CHECK_FALSE(curve_mesh(curve).triangles.empty());
    curve.points[1] = {3e38f, -3e38f, 0};
    CHECK_FALSE(curve_mesh(curve).triangles.empty());
  }
}

TEST_CASE("so many points make so many segments") {
  CHECK(segments_of(CurveBasis::bezier, 3, 4) == 1);
  CHECK(segments_of(CurveBasis::bezier, 3, 7) == 2);
  CHECK(segments_of(CurveBasis::bezier, 3, 6) == 0);
  CHECK(segments_of(CurveBasis::bezier, 2, 5) == 2);
  CHECK(segments_of(CurveBasis::bspline, 3, 6) == 3);
  CHECK(segments_of(CurveBasis::bspline, 2, 3) == 1);
  for (std::size_t few : {0, 1, 2, 3}) CHECK(segments_of(CurveBasis::bspline, 3, few) == 0);
}

}  // namespace twinray
