// SPDX-License-Identifier: Apache-2.0
#include "accel/canonical/checked_ray.h"

#include "tests/support/catch.h"
#include "tests/support/hostile.h"
#include "tests/support/trace.h"

namespace twinray {
namespace {

using test::Random;

constexpr float infinity = Aabb::infinity;
const float nan = std::numeric_limits<float>::quiet_NaN();

bool is_valid(const Ray& ray) {
  CheckedRay checked;
  return load_ray(ray, checked);
}

Ray with_direction(const Vec3& d) { return {.origin = {0, 0, 0}, .direction = d}; }
Ray with_origin(const Vec3& o) { return {.origin = o, .direction = {0, 0, 1}}; }
Ray with_interval(float t_min, float t_max) {
  return {.origin = {0, 0, 0}, .direction = {0, 0, 1}, .t_min = t_min, .t_max = t_max};
}

/// Directions and coordinates of few bits, so that a scaled direction keeps them all even where it is
/// denormal.
Vec3 few_bits(Random& random, int size) {
  const int x = random.between(-size, size);
  const int y = random.between(-size, size);
  const int z = random.between(-size, size);
  return {float(x), float(y), float(z)};
}

Vec3 scaled(const Vec3& d, int k) { return {std::ldexp(d.x, k), std::ldexp(d.y, k), std::ldexp(d.z, k)}; }

/// Whether a hit of the scaled direction has the same bits but for t's exponent.
bool is_same(const std::optional<ShapeHit>& base, const std::optional<ShapeHit>& hit, int k) {
  if (base.has_value() != hit.has_value()) return false;
  return !base || (hit->t == std::ldexp(base->t, -k) && hit->u == base->u && hit->v == base->v);
}

/// Whether t 2^-k is a normal float, or zero.
bool is_representable(float t, int k) {
  const int exponent = t == 0 ? 0 : std::ilogb(t) - k;
  return exponent > -126 && exponent < 127;
}

}  // namespace

TEST_CASE("every kind of invalid ray is refused") {
  for (const float bad : {nan, infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 p{1, 2, 3};
      p[axis] = bad;
      INFO(bad << " in component " << axis);
      CHECK_FALSE(is_valid(with_origin(p)));
      CHECK_FALSE(is_valid(with_direction(p)));
    }
  CHECK_FALSE(is_valid(with_direction({0, -0.0f, 0})));
  CHECK_FALSE(is_valid(with_origin({0, std::nextafter(0x1p60f, infinity), 0})));
  CHECK_FALSE(is_valid(with_interval(-0x1p-149f, 1)));
  CHECK_FALSE(is_valid(with_interval(2, 1)));
  CHECK_FALSE(is_valid(with_interval(nan, 1)));
  CHECK_FALSE(is_valid(with_interval(0, nan)));
  CHECK_FALSE(is_valid(with_interval(infinity, infinity)));
  CHECK_FALSE(is_valid(with_interval(0, -infinity)));
}

TEST_CASE("an invalid ray misses what lies right before it") {
  const Geometry geometry({Mesh{.positions = {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}, .triangles = {{0, 1, 2}}},
                           SphereSet{.spheres = {{{0, 0, 2}, 1}}}});
  CHECK(test::trace_all(geometry, with_direction({0, 0, 1})));
  CHECK(test::trace_all(geometry, with_direction({nan, 0, 1})).is_miss());
  CHECK(test::trace_all(geometry, with_direction({0, 0, infinity})).is_miss());
  CHECK(test::trace_all(geometry, with_interval(3, 0.5f)).is_miss());
}

TEST_CASE("the ends of the domain are valid") {
  CHECK(is_valid(with_origin({0x1p60f, -0x1p60f, 0})));
  CHECK(is_valid(with_direction({0, 0x1p-149f, 0})));
  CHECK(is_valid(with_direction({0, 0x1.fffffep127f, -0x1.fffffep127f})));
  CHECK(is_valid(with_interval(-0.0f, 0)));
  CHECK(is_valid(with_interval(0x1.fffffep127f, infinity)));
}

TEST_CASE("a direction of any size is brought into range by a power of two") {
  for (int k = -149; k <= 127; ++k) {
    CheckedRay ray;
    REQUIRE(load_ray(with_direction({std::ldexp(1.0f, k), 0, std::ldexp(-1.0f, k)}), ray));
    INFO("exponent " << k);
    CHECK((max_abs(ray.direction) >= 0x1p-40f && max_abs(ray.direction) <= 0x1p40f));
    CHECK(std::isnormal(ray.t_scale));
    CHECK(double(ray.direction.x) == std::ldexp(1.0, k) * ray.t_scale);
  }
}

TEST_CASE("a direction scaled by a power of two gives t, u and v of the same bits") {
  Random random(61);
  int triangles = 0, spheres = 0;
  for (int i = 0; i < 100000; ++i) {
    const test::Corners v = test::hostile_triangle(random);
    const Sphere sphere{random.in_cube(), random.uniform(0.5f, 2)};
    const Ray ray{.origin = random.in_cube(8), .direction = few_bits(random, 200)};
    if (max_abs(ray.direction) == 0) continue;
    Ray other = ray;
    const int k = random.between(-140, 120);
    other.direction = scaled(ray.direction, k);
    const auto hit = test::trace_triangle(ray, v[0], v[1], v[2]);
    const auto ball = test::trace_sphere(ray, sphere);
    INFO("draw " << i << " exponent " << k);
    if (!hit || is_representable(hit->t, k))
      CHECK(is_same(hit, test::trace_triangle(other, v[0], v[1], v[2]), k));
    if (!ball || is_representable(ball->t, k)) CHECK(is_same(ball, test::trace_sphere(other, sphere), k));
    triangles += hit.has_value();
    spheres += ball.has_value();
  }
  CHECK(triangles > 1000);
  CHECK(spheres > 1000);
}

TEST_CASE("a hit whose t is too large for a float is no hit") {
  const Vec3 a{-1, -1, 4}, b{1, -1, 4}, c{0, 1, 4};
  CHECK(test::trace_triangle(with_direction({0, 0, 0x1p-125f}), a, b, c)->t == 0x1p127f);
  CHECK_FALSE(test::trace_triangle(with_direction({0, 0, 0x1p-126f}), a, b, c));
  CHECK_FALSE(test::trace_triangle(with_direction({0, 0, 0x1p-149f}), a, b, c));
  CHECK_FALSE(test::trace_sphere(with_direction({0, 0, 0x1p-149f}), {{0, 0, 8}, 4}));
}

TEST_CASE("the interval is scaled with the direction") {
  const Vec3 a{-1, -1, 4}, b{1, -1, 4}, c{0, 1, 4};
  Ray ray = with_direction({0, 0, 0x1p-100f});
  ray.t_max = 0x1p102f;
  CHECK(test::trace_triangle(ray, a, b, c)->t == 0x1p102f);
  ray.t_max = std::nextafter(0x1p102f, 0.0f);
  CHECK_FALSE(test::trace_triangle(ray, a, b, c));
  ray = with_direction({0, 0, 0x1p100f});
  ray.t_min = 0x1p-98f;
  CHECK(test::trace_triangle(ray, a, b, c)->t == 0x1p-98f);
  ray.t_min = std::nextafter(0x1p-98f, 1.0f);
  CHECK_FALSE(test::trace_triangle(ray, a, b, c));
}

}  // namespace twinray
