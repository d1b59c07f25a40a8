// SPDX-License-Identifier: Apache-2.0
// The fast test of a block against the plain canonical one, for every instruction set of this machine: a tree
// of one block is asked.
#include "accel/canonical/primitive_block.h"

#include <cmath>
#include <vector>

#include "accel/accelerator.h"
#include "tests/support/block_kernels.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// Rays whose intervals end or start at what they hit, or right before or behind it.
std::vector<Ray> with_tight_intervals(const std::vector<Ray>& rays, const Accelerator& accelerator) {
  std::vector<Ray> tight = rays;
  for (const Ray& ray : rays)
    if (const Hit hit = accelerator.closest_hit(ray))
      for (const float t : {hit.t, std::nextafter(hit.t, 0.0f), std::nextafter(hit.t, Aabb::infinity)}) {
        tight.push_back({.origin = ray.origin, .direction = ray.direction, .t_min = t});
        tight.push_back({.origin = ray.origin, .direction = ray.direction, .t_max = t});
        tight.push_back({.origin = ray.origin + ray.direction * t, .direction = ray.direction});
      }
  return tight;
}

/// The geometry's triangles, every coordinate times `factor`.
Mesh scaled(Mesh mesh, float factor) {
  for (Vec3& p : mesh.positions) p = p * factor;
  return mesh;
}

}  // namespace

TEST_CASE("a block gives the canonical hit, whatever the ray's interval") {
  const auto geometry = share({soup(400, 0.7f, 11)});
  const auto oracle = build_accelerator(Backend::brute_force, geometry);
  const auto rays = with_tight_intervals(random_rays(60, geometry->bounds(), 12), *oracle);
  Tally tally;
  for (std::uint32_t first = 0; first < 400; first += 4)
    for (const Ray& ray : rays)
      compare(*geometry, {{0, first}, {0, first + 1}, {0, first + 2}, {0, first + 3}}, ray, tally);
  CHECK(tally.hits > 500);
  CHECK(tally.misses > 500);
}

TEST_CASE("a block gives the canonical hit of a hostile ray") {
  Random random(13);
  Tally tally;
  for (int i = 0; i < 100000; ++i) {
    CAPTURE(i);
    const HostilePair pair = hostile_pair(random);
    Mesh mesh;
    add_triangle(mesh, pair.corners[0], pair.corners[1], pair.corners[2]);
    const Geometry geometry({mesh});
    const std::vector<PrimitiveId> ids{{0, 0}};
    Ray ray = pair.ray;
    const Hit hit = canonical_hit(geometry, make_block(geometry, ids), ray);
    // Half of the rays get an interval of the one t.
    if (hit && random.below(2) == 0) ray.t_min = ray.t_max = hit.t;
    compare(geometry, ids, ray, tally);
  }
  CHECK(tally.hits > 25000);
  CHECK(tally.misses > 5000);
}

TEST_CASE("of equal triangles in a block the least id is hit") {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) add_triangle(mesh, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const Geometry geometry({mesh, mesh});
  Tally tally;
  for (const Ray& ray : random_rays(200, geometry.bounds(), 3)) {
    compare(geometry, {{1, 0}, {0, 3}, {0, 1}, {0, 2}}, ray, tally);
    compare(geometry, {{0, 2}, {0, 1}, {1, 1}}, ray, tally);
  }
  CHECK(tally.hits > 50);
}

TEST_CASE("a block holds spheres, triangles without area and empty lanes beside triangles") {
  Mesh mesh = soup(3, 1, 1);
  add_triangle(mesh, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  const auto geometry = share({mesh, random_spheres(2, 1, 1)});
  const std::vector<PrimitiveId> mixed{{0, 0}, {1, 0}, {0, 3}};
  const PrimitiveBlock block = make_block(*geometry, mixed);
  CHECK(block.count == 3);
  CHECK(block.triangles == 1);
  CHECK(block.spheres == 2);
  CHECK(block.others == 0);
  Tally tally;
  for (const Ray& ray : random_rays(2000, geometry->bounds(), 3)) {
    compare(*geometry, mixed, ray, tally);
    compare(*geometry, {{1, 0}, {1, 1}, {0, 2}, {0, 1}}, ray, tally);
    compare(*geometry, {{0, 3}}, ray, tally);
  }
  CHECK(tally.hits > 300);
  CHECK(tally.misses > 2000);
}

TEST_CASE("triangles too small for the proof about their boxes are tested the plain way") {
  for (const float size : {min_proved_size * 0.25f, 0x1p-100f, 0x1p-125f}) {
    const auto geometry = share({scaled(soup(100, 0.7f, 5), size)});
    std::vector<PrimitiveId> ids{{0, 0}, {0, 1}, {0, 2}, {0, 3}};
    CHECK(make_block(*geometry, ids).triangles == 0);
    const auto rays = random_rays(300, geometry->bounds(), 6);
    Tally tally;
    for (std::uint32_t first = 0; first < 100; first += 4) {
      for (std::uint32_t i = 0; i < 4; ++i) ids[i] = {0, first + i};
      for (const Ray& ray : rays) compare(*geometry, ids, ray, tally);
    }
    CHECK(tally.hits > 100);
  }
  const auto large = share({scaled(soup(4, 0.1f, 5), min_proved_size * 64)});
  CHECK(make_block(*large, std::vector<PrimitiveId>{{0, 0}, {0, 1}, {0, 2}, {0, 3}}).triangles != 0);
}
