// SPDX-License-Identifier: Apache-2.0
#include "core/transform.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray {
namespace {

/// Rounding of a product of a few matrices to float.
constexpr float tolerance = 1e-6f;

void check_near(const Vec3& a, const Vec3& b) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(max_abs(a - b) <= tolerance);
}

}  // namespace

TEST_CASE("a product applies the right factor first") {
  const Transform t = Transform::translation(10, 0, 0) * Transform::scaling(2, 3, 4);
  CHECK(t.point({1, 1, 1}) == Vec3{12, 3, 4});
  CHECK(t.vector({1, 1, 1}) == Vec3{2, 3, 4});
  const Transform other = Transform::scaling(2, 3, 4) * Transform::translation(10, 0, 0);
  CHECK(other.point({1, 1, 1}) == Vec3{22, 3, 4});
}

TEST_CASE("a rotation turns counter-clockwise looking against its axis") {
  check_near(Transform::rotation({0, 0, 2}, 90).point({1, 0, 0}), {0, 1, 0});
  check_near(Transform::rotation({0, 5, 0}, 90).point({0, 0, 1}), {1, 0, 0});
  check_near(Transform::rotation({1, 0, 0}, -90).point({0, 1, 0}), {0, 0, -1});
  check_near(Transform::rotation({1, 1, 1}, 120).point({1, 0, 0}), {0, 1, 0});
}

TEST_CASE("whole turns change nothing") {
  const Transform once = Transform::rotation({1, 2, 3}, 30),
                  again = Transform::rotation({1, 2, 3}, 30 + 360e6);
  CHECK(once.point({4, 5, 6}) == again.point({4, 5, 6}));
}

TEST_CASE("a rotation keeps lengths, angles and orientation") {
  const Transform r = Transform::rotation({0.3f, -0.2f, 0.9f}, 77.7);
  CHECK(std::fabs(r.determinant() - 1) < 1e-12);
  CHECK(length(r.vector({1, 2, 2})) == Approx(3));
}

TEST_CASE("a normal stays perpendicular to its surface") {
  const Transform t = Transform::rotation({1, 0, 1}, 33) * Transform::scaling(1, 5, 0.25);
  const Vec3 u{1, 0, -1}, v{0, 1, -1};
  const Vec3 n = t.normal(cross(u, v));
  CHECK(std::fabs(dot(normalize(n), normalize(t.vector(u)))) < tolerance);
  CHECK(std::fabs(dot(normalize(n), normalize(t.vector(v)))) < tolerance);
}

TEST_CASE("a normal follows the winding of transformed triangles, mirrored or not") {
  for (const double sign : {1.0, -1.0}) {
    const Transform t = Transform::scaling(sign * 2, 3, 1);
    const Vec3 u{1, 0.5f, 0}, v{0, 1, 1};
    CHECK(t.normal(cross(u, v)) == cross(t.vector(u), t.vector(v)));
    CHECK(t.determinant() == 6 * sign);
  }
}

}  // namespace twinray
