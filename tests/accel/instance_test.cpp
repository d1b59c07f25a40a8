// SPDX-License-Identifier: Apache-2.0
// Instances: all engines against brute force, and brute force against copies and exact arithmetic.
#include <algorithm>

#include "accel/canonical/instance_ray.h"
#include "accel/wide/invariants.h"
#include "check/judge.h"
#include "check/shape_rays.h"
#include "core/alpha_test.h"
#include "core/surface.h"
#include "tests/support/agreement.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/instances.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

constexpr RayClass classes[] = {RayClass::random,     RayClass::vertices, RayClass::edges,   RayClass::axes,
                                RayClass::box_faces,  RayClass::grazing,  RayClass::surface, RayClass::ends,
                                RayClass::directions, RayClass::far};

/// `count` rays of each class.
Rays rays_of(const std::shared_ptr<const Geometry>& geometry, int count, std::uint64_t seed) {
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  const ShapeRays shape_rays(geometry, *oracle, seed);
  Rays rays;
  for (const RayClass ray_class : classes)
    for (int i = 0; i < count; ++i) rays.push_back(shape_rays.ray(ray_class, std::uint64_t(i)));
  return rays;
}

std::vector<std::vector<Shape>> prototypes() {
  return {{soup(60, 0.3f, 1), random_spheres(6, 0.3f, 2)}, {icosphere_mesh(1)}, {soup(3, 1, 3)}};
}

}  // namespace

TEST_CASE("engines agree on instances of each kind") {
  for (const Kind kind : kinds) {
    CAPTURE(int(kind));
    const auto geometry = share_instanced({soup(40, 0.5f, 10)}, prototypes(), {kind}, 6, 11);
    CHECK(check_agreement(geometry, rays_of(geometry, 60, 12)) > 100);
  }
}

TEST_CASE("engines agree on instances of all kinds at once, with and without shapes beside them") {
  const std::vector<Kind> all(std::begin(kinds), std::end(kinds));
  for (const bool has_direct : {true, false}) {
    std::vector<Shape> direct;
    if (has_direct) direct = {soup(40, 0.5f, 20), random_spheres(10, 0.4f, 21)};
    const auto geometry = share_instanced(direct, prototypes(), all, 16, 22);
    CHECK(check_agreement(geometry, rays_of(geometry, 150, 23)) > 300);
  }
}

TEST_CASE("engines agree on a single instance, on empty prototypes and on prototypes that nothing shows") {
  const auto single = share_instanced({}, {{icosphere_mesh(1)}}, {Kind::sheared}, 1, 30);
  CHECK(check_agreement(single, rays_of(single, 60, 31)) > 100);
  Instancing instancing{{{1, 0}, {1, 1}, {2, 1}}, {{0, {}}, {1, Transform::translation(3, 0, 0)}, {0, {}}}};
  const auto mixed = std::make_shared<const Geometry>(
      std::vector<Shape>{soup(10, 0.5f, 32), icosphere_mesh(1), soup(10, 5, 33)}, nullptr, instancing);
  CHECK(check_agreement(mixed, rays_of(mixed, 60, 34)) > 100);
  const auto unseen = std::make_shared<const Geometry>(std::vector<Shape>{icosphere_mesh(1)}, nullptr,
                                                       Instancing{{{0, 1}}, {}});
  CHECK(unseen->bounds().is_empty());
  CHECK(check_agreement(unseen, random_rays(50, {{-1, -1, -1}, {1, 1, 1}}, 35)) == 0);
}

TEST_CASE("engines agree on instances that lie in each other, where the lowest instance wins") {
  Instancing instancing{{{0, 1}}, {}};
  for (int i = 0; i < 20; ++i) instancing.instances.push_back({0, Transform::translation(i / 10, 0, 0)});
  const auto geometry =
      std::make_shared<const Geometry>(std::vector<Shape>{icosphere_mesh(2)}, nullptr, instancing);
  const Rays rays = rays_of(geometry, 100, 40);
  CHECK(check_agreement(geometry, rays) > 300);
  const auto brute = build_accelerator(Backend::brute_force, geometry);
  const std::vector<std::uint32_t> first{0, 10, no_instance};
  for (const Ray& ray : rays)
    CHECK(std::find(first.begin(), first.end(), brute->closest_hit(ray).instance) != first.end());
}

TEST_CASE("engines agree on instances with holes, whose chances differ by instance") {
  const auto plain =
      share_instanced({soup(40, 0.5f, 50)}, {{soup(60, 0.4f, 51)}, {random_spheres(9, 0.4f, 52)}},
                      {Kind::rigid, Kind::mirrored}, 8, 53);
  const std::vector<Texture> textures{random_alpha(1), constant_alpha(0.5f)};
  std::vector<ShapeBinding> bindings(3);
  bindings[0].alpha = bindings[2].alpha = 1;
  bindings[1].alpha = 0;
  const auto geometry = std::make_shared<const Geometry>(
      cut_out(plain->shapes(), bindings, textures, {plain->prototypes(), plain->instances()}));
  CHECK(check_agreement(geometry, rays_of(geometry, 150, 54)) > 200);
  // Two instances in one place: what one lets pass the other may stop.
  Instancing twice{{{0, 1}}, {{0, {}}, {0, {}}}};
  const std::vector<Shape> shapes{soup(200, 0.4f, 55)};
  const std::vector<ShapeBinding> half(1, {.alpha = 1});
  const auto pair = std::make_shared<const Geometry>(cut_out(shapes, half, textures, twice));
  const auto brute = build_accelerator(Backend::brute_force, pair);
  int first = 0, second = 0;
  for (const Ray& ray : random_rays(2000, pair->bounds(), 56)) {
    const Hit hit = brute->closest_hit(ray);
    first += hit.instance == 0;
    second += hit.instance == 1;
  }
  CHECK(second > first / 4);
  CHECK(second < first);
}

TEST_CASE("instances are hit where copies of their shapes are") {
  // Rounding of positions and of transformed rays; rays that pass an edge so closely are few.
  constexpr float rounding = 1e-4f;
  for (const Kind kind : {Kind::rigid, Kind::scaled, Kind::mirrored, Kind::sheared}) {
    CAPTURE(int(kind));
    const auto geometry =
        share_instanced({soup(20, 0.5f, 60)}, {{soup(60, 0.3f, 61)}, {icosphere_mesh(2)}}, {kind}, 8, 62);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> names;
    const auto copies = flattened(*geometry, names);
    const auto instanced = build_accelerator(Backend::brute_force, geometry);
    const auto copied = build_accelerator(Backend::brute_force, copies);
    const Rays rays = random_rays(3000, geometry->bounds(), 63);
    int different = 0, hits = 0;
    for (const Ray& ray : rays) {
      const Hit a = instanced->closest_hit(ray), b = copied->closest_hit(ray);
      hits += bool(a);
      const bool same = a.is_miss() == b.is_miss() &&
                        (a.is_miss() || (names[b.mesh] == std::pair(a.instance, a.mesh) &&
                                         a.primitive == b.primitive && std::fabs(a.t - b.t) <= rounding));
      different += !same;
      if (!same || a.is_miss()) continue;
      const SurfacePoint p = surface_at(*geometry, a), q = surface_at(*copies, b);
      CHECK(length(p.position - q.position) <= rounding);
      // A copy keeps the order of its corners: where the transform mirrors, its front is behind.
      const float side = kind == Kind::mirrored && a.instance != no_instance ? -1.0f : 1.0f;
      CHECK(dot(p.geometric_normal, q.geometric_normal) * side > 1 - rounding);
      CHECK(p.instance == a.instance);
    }
    CHECK(hits > 200);
    CHECK(different <= 3);
  }
}

TEST_CASE("the hit of an instance is the exact one of the ray in its space") {
  const auto geometry =
      share_instanced({}, {{icosphere_mesh(1)}}, {std::begin(kinds), std::end(kinds)}, 16, 70);
  const auto engine = build_accelerator(Backend::bvh, geometry);
  const Rays rays = random_rays(2000, {{-5, -5, -5}, {5, 5, 5}}, 71);
  int judged = 0, wrong = 0;
  for (const Ray& ray : rays) {
    const Hit hit = engine->closest_hit(ray);
    const std::vector<JudgedHit> truth = judge_closest(*geometry, ray);
    if (truth.empty() && hit.is_miss()) continue;
    ++judged;
    wrong += std::none_of(truth.begin(), truth.end(), [&](const JudgedHit& one) {
      return one.instance == hit.instance && one.primitive == hit.primitive &&
             std::fabs(one.t.value - hit.t) <= 1e-5 * one.t.value;
    });
  }
  CHECK(judged > 300);
  CHECK(wrong <= judged / 500);  // At edges, by the ray's rounding, the neighbour.
}

TEST_CASE("closed instances leak no ray") {
  for (const Kind kind : kinds) {
    CAPTURE(int(kind));
    Random random(80);
    const Transform to_world = transform_of(kind, random);
    const auto geometry = std::make_shared<const Geometry>(std::vector<Shape>{icosphere_mesh(3)}, nullptr,
                                                           Instancing{{{0, 1}}, {{0, to_world}}});
    const auto engine = build_accelerator(Backend::bvh, geometry);
    const Vec3 center = to_world.point({0, 0, 0});
    const Mesh mesh = copied(*geometry->mesh(0), to_world);
    int leaks = 0;
    for (const Triangle& triangle : mesh.triangles)
      for (int corner = 0; corner < 3; ++corner) {
        const Vec3 a = mesh.positions[triangle[std::size_t(corner)]];
        const Vec3 b = mesh.positions[triangle[std::size_t(corner + 1) % 3]];
        for (const Vec3& target : {a, a * 0.5f + b * 0.5f, a * 0.25f + b * 0.75f})
          leaks += !engine->any_hit({.origin = center, .direction = target - center});
      }
    CHECK(leaks == 0);
  }
}

namespace {

/// How many of some rays through the inner half of an instance of a square miss it.
int lost_rays(const Transform& to_world, float distance, Random& random) {
  Mesh square{.name = "square"};
  add_triangle(square, {-1, 0, -1}, {1, 0, -1}, {1, 0, 1});
  add_triangle(square, {-1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
  const auto geometry = std::make_shared<const Geometry>(std::vector<Shape>{square}, nullptr,
                                                         Instancing{{{0, 1}}, {{0, to_world}}});
  const auto engine = build_accelerator(Backend::bvh, geometry);
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const float x = random.uniform(-0.5f, 0.5f), z = random.uniform(-0.5f, 0.5f);
    const Vec3 away = normalize(to_world.front({0, 1, 0}) + random.in_cube(0.5f)) * distance;
    lost += !engine->any_hit({.origin = to_world.point({x, 0, z}) + away, .direction = -away});
  }
  return lost;
}

}  // namespace

TEST_CASE("rays from far away miss no instance") {
  // Flat instances: their boxes are as thin as their padding. A stretch across the square makes the most of
  // what is rounded along it; a squash is along its normal, so that the rounding of a target stays small
  // beside it.
  Random random(90);
  const Transform flat = moved(random, 4);
  const Transform transforms[] = {transform_of(Kind::rigid, random),
                                  transform_of(Kind::sheared, random),
                                  flat,
                                  flat * Transform::scaling(1, 1e4, 1),
                                  flat * Transform::scaling(1, 1e-4, 1),
                                  moved(random, 4) * turned(random) * Transform::scaling(1, 1e-4, 1)};
  constexpr float distances[] = {1, 10, 1e3f, 1e5f};
  for (const Transform& to_world : transforms)
    for (const float distance : distances) {
      CAPTURE(&to_world - transforms, distance);
      CHECK(lost_rays(to_world, distance, random) == 0);
    }
}

TEST_CASE("a ray that leaves an instance does not find its triangle again") {
  for (const Kind kind : kinds) {
    CAPTURE(int(kind));
    const auto geometry =
        share_instanced({}, {{soup(60, 0.3f, 100), random_spheres(6, 0.3f, 101)}}, {kind}, 3, 102);
    const auto engine = build_accelerator(Backend::bvh, geometry);
    Random random(103);
    int found_again = 0, left = 0;
    for (const Ray& ray : rays_of(geometry, 100, 104)) {
      const Hit hit = engine->closest_hit(ray);
      if (!hit) continue;
      const SurfacePoint point = surface_at(*geometry, hit);
      for (const float side : {1.0f, -1.0f}) {
        const Vec3 normal = point.geometric_normal * side;
        Vec3 direction = normalize(random.in_ball());
        if (dot(direction, normal) < 0) direction = -direction;
        const bool is_sphere = !geometry->mesh(hit.mesh);
        if (is_sphere && side < 0) continue;
        const Hit next =
            engine->closest_hit({.origin = point.position + normal * point.offset, .direction = direction});
        ++left;
        found_again +=
            next && next.instance == hit.instance && next.mesh == hit.mesh && next.primitive == hit.primitive;
      }
    }
    CHECK(left > 100);
    CHECK(found_again == 0);
  }
}

TEST_CASE("rays from beyond a scene with instances see its boxes widened by their distance") {
  const auto geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{icosphere_mesh(1)}, nullptr,
      Instancing{{{0, 1}}, {{0, Transform::scaling(1, 100, 1)}, {0, Transform::translation(0, 0, 50)}}});
  const float reach = geometry->placed().reach(), margin = geometry->placed().far_margin();
  CHECK(reach >= 100);
  CHECK(margin == Approx(100 * 0x1p-18));
  for (const float side : {1.0f, -1.0f}) {
    CheckedRay within, beyond;
    const Vec3 direction{side, 1, -0.0f};
    REQUIRE(load_ray_into(*geometry, {.origin = {7, 99, 3}, .direction = direction}, within));
    REQUIRE(load_ray_into(*geometry, {.origin = {7, 2 * reach, 3}, .direction = direction}, beyond));
    for (int axis = 0; axis < 3; ++axis) {
      const float forward = std::signbit(direction[axis]) ? -1.0f : 1.0f;
      CHECK(within.near_origin[axis] == within.origin[axis] + forward * 99 * slab_margin);
      CHECK(beyond.near_origin[axis] == beyond.origin[axis] + forward * (2 * reach * margin));
      CHECK(beyond.far_origin[axis] == beyond.origin[axis] - forward * (2 * reach * margin));
    }
  }
}

TEST_CASE("directions of any length and invalid rays, in a scene with instances") {
  const auto geometry = share_instanced({soup(60, 0.5f, 110)}, prototypes(), {Kind::scaled}, 6, 111);
  const auto brute = build_accelerator(Backend::brute_force, geometry);
  Rays rays;
  for (const float size : {1e-44f, 1e-38f, 1e-30f, 1e-13f, 0.99f, 1e11f, 1e19f, 1e30f, 1e38f})
    for (const Ray& ray : random_rays(60, geometry->bounds(), 112))
      rays.push_back({.origin = ray.origin, .direction = ray.direction * size});
  CHECK(check_agreement(geometry, rays) > 100);
  for (const Ray& ray : random_rays(200, geometry->bounds(), 113)) {
    const Hit hit = brute->closest_hit(ray);
    Ray twice = ray;
    twice.direction = ray.direction * 64;
    const Hit scaled = brute->closest_hit(twice);
    CHECK(hit.is_miss() == scaled.is_miss());
    if (hit) CHECK(scaled.t == hit.t / 64);
  }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Rays invalid{{.origin = {nan, 0, 0}, .direction = {1, 0, 0}},
                     {.origin = {0, 0, 2e18f}, .direction = {0, 0, -1}},
                     {.origin = {}, .direction = {0, nan, 1}},
                     {.origin = {}, .direction = {0, -0.0f, 0}},
                     {.origin = {}, .direction = {1, 0, 0}, .t_min = -1},
                     {.origin = {}, .direction = {1, 0, 0}, .t_max = nan},
                     {.origin = {}, .direction = {1, 0, 0}, .t_min = 2, .t_max = 1}};
  CHECK(check_agreement(geometry, invalid) == 0);
}

TEST_CASE("the interval of a ray is closed at both ends at an instance") {
  const auto geometry = share_instanced({}, prototypes(), {Kind::rigid, Kind::sheared}, 6, 120);
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  Rays rays;
  int closed = 0;
  for (const Ray& ray : random_rays(400, geometry->bounds(), 121)) {
    const float t = oracle->closest_hit(ray).t;
    if (std::isinf(t)) continue;
    const float before = std::nextafter(t, 0.0f);
    for (const auto& [t_min, t_max] : {std::pair{t, t}, {0.0f, t}, {t, 1e30f}, {0.0f, before}})
      rays.push_back({.origin = ray.origin, .direction = ray.direction, .t_min = t_min, .t_max = t_max});
    for (std::size_t back = 2; back <= 4; ++back)
      closed += oracle->closest_hit(rays[rays.size() - back]).t == t;
    closed += !oracle->any_hit(rays.back());
  }
  CHECK(check_agreement(geometry, rays) > 100);
  CHECK(closed == int(rays.size()));
}

TEST_CASE("a hit in an instance ends the search behind it, there and in other instances") {
  Mesh layers{.name = "layers"};
  for (int i = 0; i < 200; ++i) add_triangle(layers, {-1, -1, float(i)}, {1, -1, float(i)}, {0, 1, float(i)});
  const auto geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{layers}, nullptr,
      Instancing{{{0, 1}},
                 {{0, Transform::translation(0, 0, 300)}, {0, {}}, {0, Transform::translation(0, 0, 600)}}});
  for (const int width : {2, 8}) {
    CAPTURE(width);
    const auto engine = build_accelerator(Backend::bvh, geometry, {.bvh_width = width});
    QueryCounts counts;
    const Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    CHECK(engine->closest_hit({ray, &counts}).t == 5);
    CHECK(counts.instances == 1);
    CHECK(counts.primitives <= 8);
  }
}

TEST_CASE("an instance's ray is clipped to its box") {
  const auto geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{icosphere_mesh(1)}, nullptr,
      Instancing{{{0, 1}}, {{0, Transform::translation(10, 0, 0) * Transform::scaling(2, 2, 2)}}});
  CheckedRay world, own;
  REQUIRE(load_ray_into(*geometry, {.origin = {0, 0, 0}, .direction = {1, 0, 0}}, world));
  REQUIRE(enter_instance(geometry->placed(), 0, world, 100, own));
  CHECK(own.instance == 0);
  CHECK(own.origin == Vec3{-5, 0, 0});
  CHECK(own.direction == Vec3{0.5f, 0, 0});
  CHECK(own.t_min < 8);
  CHECK(own.t_min > 7.99f);
  CHECK(own.t_max > 12);
  CHECK(own.t_max < 12.01f);
  REQUIRE(enter_instance(geometry->placed(), 0, world, 9, own));
  CHECK(own.t_max == 9);
  CHECK_FALSE(enter_instance(geometry->placed(), 0, world, 7, own));
  world.t_min = 13;
  CHECK_FALSE(enter_instance(geometry->placed(), 0, world, 100, own));
}

TEST_CASE("in a scene with instances a ray's direction is scaled") {
  const auto geometry = share_instanced({}, {{icosphere_mesh(1)}}, {Kind::rigid}, 1, 150);
  for (const float size : {1e-38f, 1e-13f, 0.3f, 1.0f, 1.99f, 1e5f, 1e19f, 1e38f}) {
    CheckedRay checked;
    REQUIRE(load_ray_into(*geometry, {.direction = {0, size, 0}, .t_max = 1e3f}, checked));
    CHECK(checked.direction.y >= 1);
    CHECK(checked.direction.y < 2);
    CHECK(checked.direction.y / checked.t_scale == Approx(double(size)));
  }
}

TEST_CASE("a tree over instances has no fault, and counts what a query does in them") {
  const auto geometry =
      share_instanced({soup(60, 0.5f, 130)}, prototypes(), {Kind::scaled, Kind::rigid}, 40, 131);
  CHECK(find_fault(build_wide(*geometry), *geometry) == "");
  CHECK(find_fault(build_wide(*geometry, {.bvh_quality = BvhQuality::high}), *geometry) == "");
  const auto wide = build_accelerator(Backend::bvh, geometry);
  const auto narrow = build_accelerator(Backend::bvh, geometry, {.bvh_width = 2});
  const auto brute = build_accelerator(Backend::brute_force, geometry);
  QueryCounts of_wide, of_narrow, of_brute;
  for (const Ray& ray : random_rays(300, geometry->bounds(), 132)) {
    wide->closest_hit({ray, &of_wide});
    narrow->closest_hit({ray, &of_narrow});
    brute->closest_hit({ray, &of_brute});
  }
  CHECK(of_wide.instances > 0);
  CHECK(of_wide.instances <= of_brute.instances);
  CHECK(of_narrow.instances <= of_brute.instances);
  CHECK(of_wide.primitives < of_brute.primitives / 2);
  for (const auto& engine : {wide.get(), narrow.get()}) {
    CHECK(engine->stats().primitives == geometry->primitive_count());
    CHECK(engine->stats().tree->sah_cost > 1);
    CHECK(engine->stats().tree->leaves > geometry->instances().size());
  }
}

TEST_CASE("a box of an instance holds what its transform makes of the prototype") {
  const auto geometry =
      share_instanced({}, {{icosphere_mesh(1)}}, {std::begin(kinds), std::end(kinds)}, 80, 140);
  for (std::uint32_t i = 0; i < geometry->instances().size(); ++i) {
    const Mesh mesh = copied(*geometry->mesh(0), geometry->instances()[i].to_world);
    Aabb box;
    for (const Vec3& position : mesh.positions) box.extend(position);
    CHECK(geometry->placed()[i].box.contains(box));
    CHECK(geometry->placed()[i].prototype == 0);
  }
}
