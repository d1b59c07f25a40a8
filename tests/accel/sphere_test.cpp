// SPDX-License-Identifier: Apache-2.0
#include "accel/canonical/sphere.h"

#include "check/judge.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_sphere.h"
#include "tests/support/trace.h"

namespace twinray {
namespace {

using test::hostile_sphere;
using test::Random;
using test::RayAndSphere;
using test::trace_sphere;

// In units of 2^-24 of centre - origin plus radius: the double computation of the closest point rounds by up
// to 32 times 2^-53 of that.
constexpr double sphere_margin = 0x1p-23;

double length_of(const Vec3& d) {
  return std::sqrt(double(d.x) * d.x + double(d.y) * d.y + double(d.z) * d.z);
}

/// How far the canonical t of a root may be from the exact one.
double t_bound(const SphereJudgement& truth, const RayAndSphere& pair, int root) {
  const double d = length_of(pair.ray.direction), rounding = 64 * 0x1p-53 * truth.scale;
  const double half_chord = 0.5 * (truth.t[1].value - truth.t[0].value) * d;
  // The squared half chord is off by that rounding times twice the radius, its root accordingly.
  const double room = 2 * pair.sphere.radius * rounding + rounding * rounding;
  const double chord = std::min(2 * std::sqrt(room), room / half_chord);
  return truth.t[root].error + std::fabs(truth.t[root].value) * 0x1p-24 + (chord + rounding) / d;
}

}  // namespace

TEST_CASE("a ray hits a sphere where the judge says, unless tangent within rounding") {
  Random random(51);
  int hits = 0, misses = 0, far_roots = 0;
  for (int i = 0; i < 150000; ++i) {
    const RayAndSphere pair = hostile_sphere(random);
    const SphereJudgement truth = judge_sphere(pair.ray, pair.sphere);
    const auto hit = trace_sphere(pair.ray, pair.sphere);
    const bool misses_clearly = truth.margin_ulps() < -sphere_margin;
    if (misses_clearly && hit) FAIL("draw " << i << " should miss");
    misses += misses_clearly;
    if (truth.margin_ulps() < sphere_margin) continue;
    const double near_bound = t_bound(truth, pair, 0), far_bound = t_bound(truth, pair, 1);
    const bool near_counts = truth.t[0].value > near_bound;
    if (truth.t[1].value > far_bound && truth.t[1].value < 0x1p127 && !hit)
      FAIL("draw " << i << " should hit");
    if (truth.t[1].value < -far_bound && hit) FAIL("draw " << i << " lies behind");
    if (!hit) continue;
    ++hits;
    const bool is_near = std::fabs(hit->t - truth.t[0].value) <= near_bound;
    const bool is_far = std::fabs(hit->t - truth.t[1].value) <= far_bound;
    if (!is_near && !is_far) FAIL("draw " << i << ": t " << hit->t << " of " << truth.t[0].value);
    if (near_counts && !is_near) FAIL("draw " << i << " skips the near root");
    far_roots += truth.t[0].value < -near_bound;
  }
  CHECK(hits > 40000);
  CHECK(misses > 8000);
  CHECK(far_roots > 15000);
}

TEST_CASE("a sphere's interval is closed: a ray that ends or starts at its hit finds it again") {
  Random random(52);
  int tested = 0;
  for (int i = 0; i < 200000; ++i) {
    RayAndSphere pair = hostile_sphere(random);
    const auto hit = trace_sphere(pair.ray, pair.sphere);
    if (!hit || hit->t < 0x1p-100f || hit->t > 0x1p100f) continue;
    ++tested;
    pair.ray.t_max = hit->t;
    const auto up_to = trace_sphere(pair.ray, pair.sphere);
    pair.ray.t_min = hit->t;
    const auto exactly = trace_sphere(pair.ray, pair.sphere);
    INFO("draw " << i);
    REQUIRE((up_to && exactly));
    CHECK((up_to->t == hit->t && exactly->t == hit->t));
    pair.ray.t_min = 0;
    pair.ray.t_max = std::nextafter(hit->t, 0.0f);
    CHECK_FALSE(trace_sphere(pair.ray, pair.sphere).has_value());
  }
  CHECK(tested > 80000);
}

TEST_CASE("beyond the near root a sphere's far root is the hit") {
  const Sphere sphere{{0, 0, 0}, 1};
  Ray ray{.origin = {0, 0, -3}, .direction = {0, 0, 1}};
  CHECK(trace_sphere(ray, sphere)->t == 2);
  ray.t_min = std::nextafter(2.0f, 3.0f);
  CHECK(trace_sphere(ray, sphere)->t == 4);
  ray.t_max = std::nextafter(4.0f, 3.0f);
  CHECK_FALSE(trace_sphere(ray, sphere).has_value());
}

TEST_CASE("u and v of a sphere's hit are its normal") {
  const auto hit = trace_sphere({.origin = {5, 2, -3}, .direction = {0, 0, 1}}, {{5, 1, 2}, 2});
  REQUIRE(hit);
  const Vec3 normal = octahedral_decode(hit->u, hit->v);
  CHECK(length(normal - Vec3{0, 0.5f, -std::sqrt(0.75f)}) < 4e-7f);
}

TEST_CASE("an exact tangent touches, the next float beyond misses") {
  const Sphere sphere{{0, 0, 0}, 1};
  const auto hit = trace_sphere({.origin = {1, -5, 0}, .direction = {0, 3, 0}}, sphere);
  REQUIRE(hit);
  CHECK(hit->t == 5 / 3.0f);
  CHECK_FALSE(trace_sphere({.origin = {std::nextafter(1.0f, 2.0f), -5, 0}, .direction = {0, 3, 0}}, sphere));
}

TEST_CASE("a sphere without a radius is never hit") {
  for (const float radius : {0.0f, -0.0f, -1.0f})
    CHECK_FALSE(trace_sphere({.origin = {0, 0, -1}, .direction = {0, 0, 1}}, {{0, 0, 0}, radius}));
}

}  // namespace twinray
