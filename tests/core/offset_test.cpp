// SPDX-License-Identifier: Apache-2.0
#include "core/offset.h"
#include "core/spawn_ray.h"

#include "tests/support/catch.h"
#include "tests/support/meshes.h"
#include "tests/support/random.h"
#include "tests/support/trace.h"

namespace twinray {
namespace {

using test::Random;

constexpr Vec3 oblique{0.37f, -0.61f, 0.83f};

/// Cosine-distributed about a unit normal, grazing directions included.
Vec3 cosine_direction(Random& random, const Vec3& normal) {
  Vec3 d;
  do d = normal + normalize(random.in_ball());
  while (!(dot(d, normal) > 1e-6f));
  return d;
}

struct Journey {
  int bounces = 0, escapes = 0, repeats = 0;
};

/// Bounces a ray about inside of a closed mesh. It escapes where it hits nothing, or a triangle's front; it
/// repeats where it hits the triangle it has just left.
Journey bounce_inside(const Geometry& geometry, const Vec3& centre, int bounces) {
  Random random(11);
  Journey journey{.bounces = bounces};
  Ray ray{.origin = centre, .direction = random.in_ball()};
  std::uint32_t left = 0xffffffff;
  for (int i = 0; i < bounces; ++i) {
    const Hit hit = test::trace_all(geometry, ray);
    journey.repeats += hit && hit.primitive == left;
    const SurfacePoint point = hit ? surface_at(geometry, hit) : SurfacePoint{};
    if (!hit || dot(point.geometric_normal, ray.direction) < 0) {
      ++journey.escapes;
      ray = {.origin = centre, .direction = random.in_ball()};
      left = 0xffffffff;
      continue;
    }
    ray = spawn_ray(point, cosine_direction(random, -point.geometric_normal));
    left = hit.primitive;
  }
  return journey;
}

/// Bounces in the mesh at all sizes and places, about `tests` triangle tests at each.
void check_closed(const Mesh& mesh, int tests) {
  for (const bool is_turned : {false, true})
    for (const float size : {1e-6f, 1.0f, 1e6f})
      for (const float away : {0.0f, 1.0f, 1000.0f}) {
        const Vec3 centre = oblique * (size * away);
        const Geometry geometry({test::placed(mesh, size, centre, is_turned)});
        const Journey journey = bounce_inside(geometry, centre, tests / int(mesh.triangles.size()));
        INFO(mesh.name << " turned " << is_turned << " size " << size << " away " << away);
        CHECK(journey.escapes == 0);
        CHECK(journey.repeats == 0);
      }
}

/// Shadow rays between random points of a closed convex mesh; how many of them hit one of their own ends.
int blocked_connections(const Geometry& geometry, int count) {
  Random random(12);
  const std::uint32_t triangles = std::uint32_t(geometry.triangle_count());
  const auto random_point = [&](std::uint32_t triangle) {
    const float u = random.unit();
    const float v = random.unit();
    return u + v < 1 ? triangle_point(geometry, 0, triangle, u, v)
                     : triangle_point(geometry, 0, triangle, 1 - u, 1 - v);
  };
  int blocked = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t from = std::uint32_t(random.below(int(triangles)));
    const std::uint32_t to = std::uint32_t(random.below(int(triangles)));
    const SurfacePoint a = random_point(from), b = random_point(to);
    const Vec3 towards = b.position - a.position;
    // Points of one plane do not see each other; which side they leave to is then up to rounding.
    if (std::fabs(dot(a.geometric_normal, towards)) < 4 * a.offset) continue;
    if (std::fabs(dot(b.geometric_normal, towards)) < 4 * b.offset) continue;
    blocked += !test::trace_all(geometry, connect(a, b)).is_miss();
  }
  return blocked;
}

}  // namespace

TEST_CASE("no ray escapes from a box, and none hits the triangle it leaves") {
  check_closed(test::box_mesh(), 1'000'000);
}

TEST_CASE("no ray escapes from a tetrahedron with its acute corners") {
  check_closed(test::tetrahedron_mesh(), 1'000'000);
  check_closed(test::subdivided(test::tetrahedron_mesh(), 2), 1'000'000);
}

TEST_CASE("no ray escapes from an icosphere") { check_closed(test::icosphere_mesh(3), 6'000'000); }

TEST_CASE("no ray escapes from a star with spikes and hollows") {
  check_closed(test::star_mesh(2, 3), 2'000'000);
}

TEST_CASE("shadow rays inside of a convex mesh are never blocked") {
  for (const Mesh& mesh : {test::box_mesh(), test::tetrahedron_mesh(), test::icosphere_mesh(1)})
    for (const float away : {0.0f, 1.0f, 1000.0f}) {
      INFO(mesh.name << " away " << away);
      CHECK(blocked_connections(Geometry({test::placed(mesh, 1, oblique * away, true)}), 20000) == 0);
    }
}

TEST_CASE("a shadow ray from afar is not blocked by the small lamp that it goes to, wherever that is") {
  Random random(14);
  const Sphere sphere{{0, 0, 0}, 0.25f};
  for (int i = 0; i < 100000; ++i) {
    const Vec3 away = normalize(random.in_ball());
    const float distance = std::ldexp(random.uniform(1, 2), random.between(0, 10));
    const SurfacePoint from{.position = away * distance, .geometric_normal = -away, .offset = 1e-6f};
    const Vec3 side = cosine_direction(random, away);
    const SurfacePoint on_sphere = sphere_point(sphere, 0, normalize(side));
    INFO("draw " << i << ", distance " << distance);
    if (dot(on_sphere.geometric_normal, from.position - on_sphere.position) > 0)
      CHECK_FALSE(test::trace_sphere(connect(from, on_sphere), sphere).has_value());
    const Vec3 a = random.in_cube(0.25f), b = random.in_cube(0.25f), c = random.in_cube(0.25f);
    Mesh lamp{.positions = {a, b, c}, .triangles = {{0, 1, 2}}};
    const Geometry geometry({lamp});
    const SurfacePoint on_triangle = triangle_point(geometry, 0, 0, 0.3f, 0.4f);
    // From about its plane, which side it is seen from is up to rounding.
    const float height = dot(on_triangle.geometric_normal, from.position - on_triangle.position);
    if (std::fabs(height) > 1e-4f * distance)
      CHECK(test::trace_all(geometry, connect(from, on_triangle)).is_miss());
  }
}

TEST_CASE("a shadow ray's ends lie on the sides that face each other, and its t_max is 1") {
  SurfacePoint below{.position = {0, 0, 0}, .geometric_normal = {0, 0, -1}, .offset = 0.25f};
  SurfacePoint above{.position = {3, 0, 8}, .geometric_normal = {0, 0, -1}, .offset = 0.5f};
  const Ray ray = connect(below, above);
  CHECK(ray.origin == Vec3{0, 0, 0.25f});
  CHECK(ray.origin + ray.direction == Vec3{3, 0, 7.5f - 12 * 8 * 0x1p-24f});
  CHECK(ray.t_min == 0);
  CHECK(ray.t_max == 1);
  const Ray to_point = connect(below, Vec3{1, 2, -3});
  CHECK(to_point.origin == Vec3{0, 0, -0.25f});
  CHECK(to_point.origin + to_point.direction == Vec3{1, 2, -3});
  CHECK(to_point.t_max == 1);
}

TEST_CASE("a ray spawned from a sphere, inward or outward, does not hit its start again") {
  Random random(13);
  for (int i = 0; i < 200000; ++i) {
    const Sphere sphere{random.in_cube(std::ldexp(1.0f, random.between(-10, 10))),
                        std::ldexp(random.uniform(1, 2), random.between(-10, 10))};
    const SurfacePoint point = sphere_point(sphere, 0, normalize(random.in_ball()));
    const Vec3 out = cosine_direction(random, point.geometric_normal);
    INFO("draw " << i);
    CHECK_FALSE(test::trace_sphere(spawn_ray(point, out), sphere).has_value());
    const Vec3 in = cosine_direction(random, -point.geometric_normal);
    if (point.offset * 16 > sphere.radius) continue;  // the centre is so far away that no inside is left
    const auto far = test::trace_sphere(spawn_ray(point, in), sphere);
    REQUIRE(far.has_value());
    const Vec3 there = octahedral_decode(far->u, far->v);
    if (-dot(point.geometric_normal, in) > 0.1f * length(in))
      CHECK(dot(there, point.geometric_normal) < 0.99f);
  }
}

TEST_CASE("an offset is ten roundings of coordinate and edge, at any size") {
  const Vec3 a{1, 2, 3}, b{5, 2, 3}, c{1, 4, -1};
  CHECK(triangle_offset(a, b, c) == 10 * 0x1p-24f * 9);
  CHECK(triangle_offset(a * 0x1p40f, b * 0x1p40f, c * 0x1p40f) == 10 * 0x1p-24f * 9 * 0x1p40f);
  CHECK(sphere_offset({1, -6, 3}, 2) == 10 * 0x1p-24f * 8);
}

}  // namespace twinray
