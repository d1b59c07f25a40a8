// SPDX-License-Identifier: Apache-2.0
#include "core/octahedron.h"

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

// u and v round by up to 2^-25, the octahedron's point by sqrt(6) 2^-24, its direction by sqrt(3) times that:
// 2.5e-7; the rest is the rounding of the two unit vectors compared.
constexpr float direction_error = 4e-7f;

}  // namespace

TEST_CASE("the axes survive the octahedral map exactly") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      double d[3] = {0, 0, 0};
      d[axis] = side;
      const Vec2 uv = octahedral_encode(d[0], d[1], d[2]);
      CHECK(octahedral_decode(uv.x, uv.y) == Vec3{float(d[0]), float(d[1]), float(d[2])});
    }
}

TEST_CASE("a direction survives the octahedral map within rounding, whatever its length") {
  test::Random random(71);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 d = random.in_ball();
    const double scale = std::ldexp(1.0, random.between(-300, 300));
    const Vec2 uv = octahedral_encode(d.x * scale, d.y * scale, d.z * scale);
    INFO("draw " << i);
    CHECK((uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1));
    CHECK(length(octahedral_decode(uv.x, uv.y) - normalize(d)) < direction_error);
  }
}

TEST_CASE("every point of the square is a unit vector") {
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; j <= 64; ++j)
      CHECK(length(octahedral_decode(float(i) / 64, float(j) / 64)) == Approx(1).epsilon(1e-6));
}

TEST_CASE("the upper half of the sphere is the inner diamond of the square") {
  test::Random random(72);
  for (int i = 0; i < 10000; ++i) {
    const float u = random.unit();
    const float v = random.unit();
    const float diamond = std::fabs(2 * u - 1) + std::fabs(2 * v - 1);
    if (diamond < 1) CHECK(octahedral_decode(u, v).z > 0);
    if (diamond > 1) CHECK(octahedral_decode(u, v).z < 0);
  }
}

}  // namespace twinray
