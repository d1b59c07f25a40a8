// SPDX-License-Identifier: Apache-2.0
#include "io/cs184/normals.h"

#include "tests/support/catch.h"

namespace twinray {
namespace {

constexpr float normal_tolerance = 1e-6f;

FaceList faces(std::initializer_list<std::vector<std::uint32_t>> list) {
  FaceList result;
  for (const auto& face : list) result.add(face);
  return result;
}

void check_normal(const Vec3& a, const Vec3& b) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(length(a - b) <= normal_tolerance);
}

const std::vector<DoublePoint> square_points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<DoublePoint> pyramid_points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 3}};

}  // namespace

TEST_CASE("the normals of an open flat patch are the opposite of its winding's") {
  for (const FaceList& list : {faces({{0, 1, 2, 3}}), faces({{0, 1, 2}, {0, 2, 3}})}) {
    const VertexNormals result = cs184_normals(list, square_points);
    CHECK(result.fault == "");
    for (const Vec3& normal : result.normals) CHECK(normal == Vec3{0, 0, -1});
  }
}

TEST_CASE("the normals of a closed mesh are smooth, weighted by area, and on the side of its winding") {
  const VertexNormals result =
      cs184_normals(faces({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {3, 2, 1, 0}}), pyramid_points);
  CHECK(result.fault == "");
  check_normal(result.normals[4], {0, 0, 1});
  // The two sides give (3, 3, 1) and (3, -3, 1), and the bottom's three corners around 0 give (0, 0, -2).
  check_normal(result.normals[0], {1, 0, 0});
}

TEST_CASE("within an open mesh only the vertices on the border follow its rule") {
  const VertexNormals result =
      cs184_normals(faces({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}), pyramid_points);
  CHECK(result.fault == "");
  check_normal(result.normals[4], {0, 0, 1});
  // Before 0 on the border is 3, whose neighbours are 0, 2 and 4: as seen from 0,
  // (-1, -1, 0) x ((0, 0, 0) + (-2, 0, 0) + (-1, 0, 3)) = (-3, 3, -3).
  check_normal(result.normals[0], normalize(Vec3{-3, 3, -3}));
}

TEST_CASE("faces that form no manifold say why, and have smooth normals without the border's rule") {
  const auto fault = [](const FaceList& list) {
    const VertexNormals result = cs184_normals(list, pyramid_points);
    CHECK(result.normals[0].z > 0);
    return result.fault;
  };
  CHECK(fault(faces({{0, 1, 4}, {0, 1, 4}})) ==
        "two faces have the edge from vertex 0 to vertex 1 in the same direction");
  CHECK(fault(faces({{0, 1, 4}, {2, 3, 4}})) == "the faces around vertex 4 are not one fan");
  CHECK(fault(faces({{0, 1, 2, 1, 4}})) == "a face has the vertex 1 twice");
}

TEST_CASE("two closed surfaces that share a vertex are no manifold") {
  const std::vector<DoublePoint> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                        {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const FaceList list =
      faces({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}});
  CHECK(cs184_normals(list, points).fault == "the faces around vertex 0 are not one fan");
}

TEST_CASE("a vertex without faces, or with faces of no area alone, has no normal") {
  const std::vector<DoublePoint> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}};
  for (const Vec3& normal : cs184_normals(faces({{0, 1, 2}}), points).normals) CHECK(normal == Vec3{0, 0, 0});
  CHECK(cs184_normals({}, {}).normals.empty());
}

}  // namespace twinray
