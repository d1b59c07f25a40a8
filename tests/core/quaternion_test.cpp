// SPDX-License-Identifier: Apache-2.0
#include "core/quaternion.h"

#include <cmath>

#include "tests/support/catch.h"

namespace twinray {
namespace {

constexpr double tolerance = 1e-12;

/// The largest difference of their numbers.
double difference(const Transform& a, const Transform& b) {
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      largest = std::max(largest, std::fabs(a.m[row][column] - b.m[row][column]));
  return largest;
}

Transform turn(const Vec3& axis, double degrees) { return Transform::rotation(axis, degrees); }

}  // namespace

TEST_CASE("a rotation's quaternion is the rotation again, through every angle and about every axis") {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, -2, 3}, Vec3{-3, 1, 1}})
    for (double degrees = -180; degrees <= 180; degrees += 15) {
      const Transform rotation = turn(axis, degrees);
      CHECK(difference(rotation_of(quaternion_of(rotation)), rotation) < tolerance);
    }
}

TEST_CASE("between two rotations the shorter way is taken evenly") {
  const Vec3 axis{1, 2, -1};
  const Quaternion from = quaternion_of(turn(axis, 20)), to = quaternion_of(turn(axis, 110));
  for (const double t : {0.0, 0.25, 0.5, 1.0})
    CHECK(difference(rotation_of(slerp(from, to, t)), turn(axis, 20 + 90 * t)) < tolerance);
  const Quaternion far = quaternion_of(turn(axis, 320));
  CHECK(difference(rotation_of(slerp(from, far, 0.5)), turn(axis, -10)) < tolerance);
  const Quaternion minus{-to.x, -to.y, -to.z, -to.w}, longer{3 * from.x, 3 * from.y, 3 * from.z, 3 * from.w};
  CHECK(difference(rotation_of(slerp(longer, minus, 0.5)), turn(axis, 65)) < tolerance);
}

TEST_CASE("a quaternion without a direction turns nothing") {
  CHECK(difference(rotation_of({0, 0, 0, 0}), {}) == 0);
}

TEST_CASE("transforms are stretched, turned and moved evenly from one to the other") {
  const auto placed = [](double x, double degrees, double height) {
    return Transform::translation(x, 1, 2) * turn({0, 1, 1}, degrees) * Transform::scaling(1, height, 2);
  };
  const Transform from = placed(0, 10, 1), to = placed(4, 130, 3);
  for (const double t : {0.0, 0.3, 0.5, 1.0})
    CHECK(difference(interpolated(from, to, t), placed(4 * t, 10 + 120 * t, 1 + 2 * t)) < 10 * tolerance);
}

TEST_CASE("size and mirrors do not matter to what is in between") {
  const double tiny = 1e-12, huge = 1e12;
  for (const double size : {tiny, 1.0, huge})
    for (const double sign : {1.0, -1.0}) {
      const Transform part = Transform::scaling(sign * size, size, 2 * size);
      const Transform middle = interpolated(part, turn({0, 0, 1}, 90) * part, 0.5);
      CHECK(difference(middle, turn({0, 0, 1}, 45) * part) < tolerance * size);
    }
}

TEST_CASE("where a transform flattens, its numbers change evenly") {
  const Transform flat = Transform::scaling(1, 0, 1), full = turn({0, 0, 1}, 90);
  const Transform middle = interpolated(flat, full, 0.5);
  CHECK(middle.m[0][0] == Approx(0.5));
  CHECK(middle.m[1][0] == Approx(0.5));
  CHECK(middle.m[2][2] == Approx(1));
}

}  // namespace twinray
