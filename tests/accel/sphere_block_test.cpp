// SPDX-License-Identifier: Apache-2.0
// The spheres of a block, tested in lanes, against the plain canonical test: for every instruction set of
// this machine, bit for bit.
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/block_kernels.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_sphere.h"
#include "tests/support/shapes.h"
#include "tests/support/wide_engine.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// As many spheres as fit into a block, of one set.
std::vector<PrimitiveId> block_of(const Geometry& geometry, std::uint32_t first = 0) {
  std::vector<PrimitiveId> ids;
  for (std::uint32_t i = first; i < geometry.sphere_count() && ids.size() < 4; ++i) ids.push_back({0, i});
  return ids;
}

/// Asks about a ray, and about intervals that end or start at what it hits, or one float before or behind it.
void compare_ends(const Geometry& geometry, const std::vector<PrimitiveId>& ids, const Ray& ray,
                  Tally& tally) {
  compare(geometry, ids, ray, tally);
  const Hit hit = canonical_hit(geometry, make_block(geometry, ids), ray);
  if (!hit) return;
  for (const float t : {hit.t, std::nextafter(hit.t, 0.0f), std::nextafter(hit.t, Aabb::infinity)}) {
    const auto [from, to] = std::pair{std::max(ray.t_min, t), std::min(ray.t_max, t)};
    compare(geometry, ids, {.origin = ray.origin, .direction = ray.direction, .t_min = from}, tally);
    compare(geometry, ids, {.origin = ray.origin, .direction = ray.direction, .t_max = to}, tally);
    compare(geometry, ids, {.origin = ray.origin, .direction = ray.direction, .t_min = t, .t_max = t}, tally);
  }
}

/// Three more spheres around or beside one, of about its size, inside of it, or the same.
std::vector<Sphere> with_neighbours(Random& random, const Sphere& sphere) {
  std::vector<Sphere> spheres{sphere};
  while (spheres.size() < 4) {
    const float scale = random.below(3) == 0 ? 1.0f : std::ldexp(1.0f, random.between(-3, 3));
    const Vec3 shift = random.below(3) == 0 ? Vec3{} : random.in_cube(2 * sphere.radius);
    spheres.push_back({sphere.center + shift, sphere.radius * scale});
  }
  return spheres;
}

float any_size(Random& random, int least, int largest) {
  return std::ldexp(random.uniform(1, 2), random.between(least, largest));
}

}  // namespace

TEST_CASE("spheres in lanes give the canonical hit of a hostile ray") {
  Random random(61);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const RayAndSphere pair = hostile_sphere(random);
    const Geometry geometry({SphereSet{.spheres = with_neighbours(random, pair.sphere)}});
    compare_ends(geometry, block_of(geometry), pair.ray, tally);
  }
  CHECK(tally.hits > 50000);
  CHECK(tally.misses > 15000);
}

TEST_CASE("spheres of any size at any place give the canonical hit in lanes") {
  Random random(62);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    // Radii from denormal to the largest that a scene may have; centres likewise, some in an axis plane, some
    // a radius beside one.
    Sphere sphere{random.in_cube(any_size(random, -149, 35)), any_size(random, -149, 35)};
    const int axis = random.below(3);
    if (random.below(3) == 0) sphere.center[axis] = random.below(2) ? 0.0f : -0.0f;
    if (random.below(3) == 0) sphere.center[axis] = std::copysign(sphere.radius, sphere.center[axis]);
    const Geometry geometry({SphereSet{.spheres = with_neighbours(random, sphere)}});
    const Vec3 target = sphere.center + random.in_ball() * sphere.radius;
    const float distance =
        random.below(2) ? sphere.radius * any_size(random, -24, 4) : any_size(random, -149, 59);
    const Vec3 origin = target + random.in_ball() * distance;
    compare_ends(geometry, block_of(geometry),
                 {.origin = origin, .direction = hostile_direction(random, origin, target)}, tally);
  }
  CHECK(tally.hits > 40000);
  CHECK(tally.misses > 15000);
}

TEST_CASE("rays along axes, from the centre and from the poles of a sphere give the canonical hit in lanes") {
  const Geometry geometry({SphereSet{.spheres = {{{1, 0, -0.0f}, 1}, {{0, 0, 0}, 1}, {{-1, 0, 0}, 2}}}});
  Tally tally;
  for (int code = 1; code < 27; ++code) {
    const Vec3 direction{float(code % 3 - 1), float(code / 3 % 3 - 1), float(code / 9 - 1)};
    for (const float sign : {1.0f, -1.0f})
      for (const Vec3& origin : {Vec3{}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0},
                                 Vec3{-3, 0, 0}, Vec3{3, 1, 0}, Vec3{0, 0x1p-149f, -0.0f}})
        compare_ends(geometry, block_of(geometry), {.origin = origin, .direction = direction * sign}, tally);
  }
  CHECK(tally.hits > 400);
  CHECK(tally.misses > 400);
}

TEST_CASE("an invalid ray misses a block of spheres") {
  const Geometry geometry({SphereSet{.spheres = {{{0, 0, 0}, 1}}}});
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = Aabb::infinity;
  Tally tally;
  for (const float bad : {nan, infinity, -infinity, 0x1p61f})
    for (int axis = 0; axis < 3; ++axis) {
      Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}};
      ray.origin[axis] = bad;
      compare(geometry, block_of(geometry), ray, tally);
    }
  for (const Ray& ray : {Ray{.origin = {}, .direction = {}}, Ray{.origin = {}, .direction = {nan, 0, 1}},
                         Ray{.origin = {}, .direction = {0, 0, 1}, .t_min = -1},
                         Ray{.origin = {}, .direction = {0, 0, infinity}},
                         Ray{.origin = {}, .direction = {0, 0, 1}, .t_min = 2, .t_max = 1},
                         Ray{.origin = {}, .direction = {0, 0, 1}, .t_min = nan}})
    compare(geometry, block_of(geometry), ray, tally);
  CHECK(tally.hits == 0);
  compare(geometry, block_of(geometry), {.origin = {}, .direction = {0, 0, 1}}, tally);
  CHECK(tally.hits == 1);
}

TEST_CASE("of equal spheres in a block the least id is hit, and of those with a triangle at the same t") {
  const SphereSet twins{.spheres = {{{0, 0, 3}, 1}, {{0, 0, 3}, 1}, {{0, 0, 3}, 1}}};
  Mesh mesh;
  add_triangle(mesh, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  const Geometry geometry({twins, mesh, twins});
  const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}};
  const auto first_of = [&](const std::vector<PrimitiveId>& ids) {
    Tally tally;
    compare(geometry, ids, ray, tally);
    const Hit hit = canonical_hit(geometry, make_block(geometry, ids), ray);
    CHECK(hit.t == 2);
    return PrimitiveId{hit.mesh, hit.primitive};
  };
  CHECK(first_of({{2, 1}, {0, 2}, {0, 1}, {2, 0}}) == PrimitiveId{0, 1});
  CHECK(first_of({{2, 2}, {1, 0}, {2, 0}}) == PrimitiveId{1, 0});
  CHECK(first_of({{1, 0}, {0, 0}}) == PrimitiveId{0, 0});
}

TEST_CASE("of equal spheres the least id is hit, whichever block comes first") {
  const auto geometry = share({SphereSet{.spheres = std::vector<Sphere>(40, {{0, 0, 3}, 1})}});
  for (const WideKernel& kernel : wide_kernels()) {
    CAPTURE(kernel.name);
    const WideBvh bvh = build_wide(*geometry);
    REQUIRE(bvh.blocks.size() > 2);
    const Hit hit = kernel.closest(bvh, *geometry, {.origin = {0, 0, 0}, .direction = {0, 0, 1}});
    CHECK(hit.primitive == 0);
  }
}

TEST_CASE("in a tree a sphere takes the bytes of a triangle") {
  const auto bytes = [](std::vector<Shape> shapes) {
    const Geometry geometry(std::move(shapes));
    return double(build_wide(geometry).bytes()) / double(geometry.primitive_count());
  };
  Mesh patches;  // A small triangle at the centre of each sphere.
  const SphereSet spheres = random_spheres(4000, 0.02f, 63);
  for (const auto& [center, radius] : spheres.spheres)
    add_triangle(patches, center - Vec3{radius, radius, radius}, center + Vec3{radius, 0, radius},
                 center + Vec3{0, radius, radius});
  CHECK(bytes({spheres}) == Approx(bytes({patches})).epsilon(0.05));
  CHECK(bytes({spheres}) == Approx(145).margin(5));
}

TEST_CASE("a block of spheres says what is tested in lanes") {
  const Geometry geometry({SphereSet{.spheres = {{{1, 2, 3}, 4}, {{5, 6, 7}, 0}, {{0, 0, 0}, 0x1p-149f}}}});
  const PrimitiveBlock block = make_block(geometry, block_of(geometry));
  CHECK(block.count == 3);
  CHECK(block.spheres == 0b101);
  CHECK(block.others == 0);
  CHECK(block.triangles == 0);
  CHECK(block.radii()[0] == 4);
  const Aabb box = sphere_bounds({{1, 2, 3}, 4});
  CHECK(box.lower.x - block.paddings()[0] == padded(box).lower.x);
  CHECK(box.upper.z + block.paddings()[0] == padded(box).upper.z);
}
