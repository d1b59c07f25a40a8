// SPDX-License-Identifier: Apache-2.0
#include "accel/canonical/slab.h"

#include "accel/canonical/triangle.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"

namespace twinray {
namespace {

using test::HostilePair;
using test::Random;

SlabInterval slab(const CheckedRay& ray, const Aabb& box) { return intersect_slab(ray, padded(box)); }

CheckedRay checked(const Ray& ray) {
  CheckedRay loaded;
  REQUIRE(load_ray(ray, loaded));
  return loaded;
}

/// A ray and a box beside which it passes, by as much as the test of a triangle may be wrong.
struct NearMiss {
  Ray ray;
  Aabb box;
  double t;  ///< Where it does.
};

/// The largest float at most x, or the least one at least x.
float rounded(double x, bool down) {
  const auto nearest = float(x);
  if (down && double(nearest) > x) return std::nextafter(nearest, -Aabb::infinity);
  if (!down && double(nearest) < x) return std::nextafter(nearest, Aabb::infinity);
  return nearest;
}

/// Woop's test takes a vertex for up to 6 u D (u = 2^-24) beside its place, in each of the two components
/// across the ray's dominant axis; D is the largest component of vertex - origin. So a box may lie as far
/// beside the ray as that, and one of its triangles be hit. The rays here are at all angles to the axis; the
/// origin lies on the other side of the origin of coordinates than the box, for which D is largest.
NearMiss near_miss(Random& random) {
  constexpr double most = 0.999 * 6 * 0x1p-24;
  const int along = random.below(3);
  const float size = std::ldexp(1.0f, random.between(-40, 38)), way = random.below(2) ? 1.0f : -1.0f;
  Ray ray{.origin = random.in_cube(size * 0.25f)};
  ray.origin[along] = -way * size;
  for (int axis = 0; axis < 3; ++axis) {
    const float slope = std::ldexp(random.uniform(-1, 1), -random.between(0, 50));
    ray.direction[axis] = axis == along ? way : random.below(4) == 0 ? 0.0f : slope;
  }
  const double t = double(size) * double(random.uniform(1.5f, 2));
  double place[3], distance = 0;
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = double(ray.origin[axis]) + t * double(ray.direction[axis]);
    distance = std::max(distance, std::fabs(place[axis] - double(ray.origin[axis])));
  }
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_below = random.below(2);
    const double beside = axis == along ? -distance * 0x1p-20 : distance * most;
    const double face = is_below ? place[axis] - beside : place[axis] + beside;
    const float near = rounded(face, !is_below),
                far = near + (is_below ? -size : size) * random.unit() * 0.1f;
    box.lower[axis] = std::min(near, far);
    box.upper[axis] = std::max(near, far);
  }
  return {ray, box, t};
}

/// A box that contains another: equal to it in some faces, beyond it by an ulp or by anything in others.
Aabb enclosing(Random& random, const Aabb& box) {
  Aabb outer = box;
  for (int axis = 0; axis < 3; ++axis) {
    const float far = std::ldexp(1.0f, random.between(-30, 30));
    const int lower = random.below(3), upper = random.below(3);
    if (lower == 1) outer.lower[axis] = std::nextafter(outer.lower[axis], -Aabb::infinity);
    if (lower == 2) outer.lower[axis] -= far;
    if (upper == 1) outer.upper[axis] = std::nextafter(outer.upper[axis], Aabb::infinity);
    if (upper == 2) outer.upper[axis] += far;
  }
  return outer;
}

}  // namespace

TEST_CASE("a box that contains another has a near no larger and a far no smaller, bit for bit") {
  Random random(41);
  for (int i = 0; i < 500000; ++i) {
    HostilePair pair = test::hostile_pair(random);
    const auto& [a, b, c] = pair.corners;
    const Aabb inner = triangle_bounds(a, b, c), outer = enclosing(random, inner);
    if (random.below(8) == 0) pair.ray.origin[random.below(3)] = inner.lower[random.below(3)];
    const CheckedRay ray = checked(pair.ray);
    const SlabInterval small = slab(ray, inner), large = slab(ray, outer);
    if (!(large.near <= small.near && large.far >= small.far)) FAIL("draw " << i);
  }
}

TEST_CASE("the padding of boxes is monotone and outward") {
  Random random(42);
  for (int i = 0; i < 200000; ++i) {
    const test::Corners v = test::hostile_triangle(random);
    const Aabb inner = triangle_bounds(v[0], v[1], v[2]), outer = enclosing(random, inner);
    if (!padded(outer).contains(padded(inner)) || !padded(inner).contains(inner)) FAIL("draw " << i);
  }
  CHECK(padded(Aabb()).is_empty());
}

TEST_CASE("the box of a triangle never rejects a hit of its edge functions, nor moves it") {
  Random random(43);
  int accepted = 0;
  for (int i = 0; i < 1000000; ++i) {
    const HostilePair pair = test::hostile_pair(random);
    const auto& [a, b, c] = pair.corners;
    const CheckedRay ray = checked(pair.ray);
    const ShearedVertex p = shear(ray, a), q = shear(ray, b), r = shear(ray, c);
    ShapeHit hit;
    if (!EdgeFunctions<double>(p, q, r).interpolate(p, q, r, hit) || !(hit.t >= 0)) continue;
    ++accepted;
    const SlabInterval interval = slab(ray, triangle_bounds(a, b, c));
    if (!(interval.near <= hit.t && hit.t <= interval.far))
      FAIL("draw " << i << ": near " << interval.near << " t " << hit.t << " far " << interval.far);
  }
  CHECK(accepted > 300000);
}

TEST_CASE("a box is met by every ray that passes it within what a triangle's test rounds by") {
  Random random(46);
  for (int i = 0; i < 200000; ++i) {
    const NearMiss miss = near_miss(random);
    const SlabInterval interval = slab(checked(miss.ray), miss.box);
    if (!(double(interval.near) <= miss.t && miss.t <= double(interval.far)))
      FAIL("draw " << i << ": near " << interval.near << " t " << miss.t << " far " << interval.far);
  }
}

TEST_CASE("an origin on a face, with a zero component of either sign, intersects the box") {
  const Aabb box{{-1, -2, -3}, {1, 2, 3}};
  for (const float zero : {0.0f, -0.0f})
    for (const float face : {-1.0f, 1.0f}) {
      const SlabInterval along = slab(checked({.origin = {face, 0, -10}, .direction = {zero, zero, 1}}), box);
      CHECK(along.near <= 7);
      CHECK(along.far >= 13);
      const SlabInterval beside =
          slab(checked({.origin = {face * 1.001f, 0, -10}, .direction = {zero, zero, 1}}), box);
      CHECK(beside.near > beside.far);
    }
}

TEST_CASE("a slab's interval is never NaN, whatever the ray") {
  Random random(44);
  for (int i = 0; i < 300000; ++i) {
    HostilePair pair = test::hostile_pair(random);
    for (int axis = 0; axis < 3; ++axis) {
      if (random.below(4) == 0) pair.ray.direction[axis] = std::ldexp(1.0f, random.between(-149, 127));
      if (random.below(4) == 0)
        pair.ray.origin[axis] = std::ldexp(random.uniform(-1, 1), random.between(-149, 60));
    }
    const auto& [a, b, c] = pair.corners;
    const SlabInterval interval = slab(checked(pair.ray), triangle_bounds(a, b, c));
    if (std::isnan(interval.near) || std::isnan(interval.far)) FAIL("draw " << i);
  }
}

TEST_CASE("an empty box is never met") {
  Random random(45);
  for (int i = 0; i < 1000; ++i) {
    const SlabInterval interval = slab(checked(test::hostile_pair(random).ray), Aabb());
    CHECK(interval.near > interval.far);
  }
}

TEST_CASE("a clamped t stays within box and interval") {
  const CheckedRay ray = checked({.origin = {0, 0, -10}, .direction = {0, 0, 1}, .t_min = 2});
  const Aabb box{{-1, -1, -1}, {1, 1, 1}};
  const SlabInterval interval = slab(ray, box);
  float t = 3;
  CHECK(clamp_to_box(ray, box, 100, t));
  CHECK(t == interval.near);
  t = 30;
  CHECK(clamp_to_box(ray, box, 100, t));
  CHECK(t == interval.far);
  t = 10;
  CHECK(clamp_to_box(ray, box, 10, t));
  CHECK(t == 10);
  CHECK_FALSE(clamp_to_box(ray, box, std::nextafter(10.0f, 0.0f), t));
  CHECK_FALSE(clamp_to_box(ray, {{3, 3, 3}, {4, 4, 4}}, 100, t));
}

}  // namespace twinray
