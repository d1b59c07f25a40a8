// SPDX-License-Identifier: Apache-2.0
#include "core/transform.h"

#include <cmath>
#include <limits>

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
  const Vec3 n = t.front(cross(u, v));
  CHECK(length(n) == Approx(1));
  CHECK(std::fabs(dot(n, normalize(t.vector(u)))) < tolerance);
  CHECK(std::fabs(dot(n, normalize(t.vector(v)))) < tolerance);
}

TEST_CASE("a normal stays in front, where a transform mirrors, too") {
  for (const double sign : {1.0, -1.0}) {
    const Transform t = Transform::scaling(sign * 2, 3, 1);
    const Vec3 u{1, 0.5f, 0}, v{0, 1, 1};
    const Vec3 front = normalize(cross(t.vector(u), t.vector(v))) * float(sign);
    CHECK(length(t.front(cross(u, v)) - front) < tolerance);
    CHECK(t.determinant() == 6 * sign);
  }
}

TEST_CASE("a normal is a unit vector whatever the size of the transform or of the normal, or is none") {
  const Vec3 expected = normalize(Vec3{1, 1, 3});
  for (const double size : {1e-150, 1e-60, 1e-10, 1.0, 1e10, 1e60, 1e150})
    for (const float length_of_normal : {1e-30f, 1.0f, 1e18f}) {
      const Transform t = Transform::scaling(size, 2 * size, size);
      CHECK(length(t.front(Vec3{1, 2, 3} * length_of_normal) - expected) < tolerance);
    }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Vec3 none{0, 0, 0}, up{0, 0, 1};
  CHECK(Transform{}.front(none) == none);
  CHECK(Transform{}.front({nan, 0, 1}) == none);
  CHECK(Transform::scaling(0, 0, 0).front(up) == none);
  CHECK(Transform::scaling(1, 0, 1).front(up) == none);
  CHECK(Transform::scaling(1, 1, 0).front(up) == up);
}

}  // namespace twinray
