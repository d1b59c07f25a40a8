// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/occlusion.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/shapes.h"
#include "tests/support/trace.h"

using namespace twinray;
using namespace twinray::test;

namespace {

/// Of many random lines that intersect a box within the unit cube, the share that hits a geometry.
double share_of_hits(const Geometry& geometry, const Aabb& box) {
  Random random(3);
  int met = 0, hit = 0;
  for (int i = 0; i < 400000; ++i) {
    // Lines through points of a disc that hides the cube from a random direction: all lines are alike.
    const Vec3 direction = normalize(random.in_ball());
    const Vec3 aside =
        normalize(cross(direction, std::fabs(direction.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 up = cross(direction, aside);
    const float u = 4 * random.unit() - 2, v = 4 * random.unit() - 2;
    const Ray ray{.origin = aside * u + up * v - direction * 4, .direction = direction};
    CheckedRay loaded;
    REQUIRE(load_ray(ray, loaded));
    const SlabInterval interval = intersect_slab(loaded, padded(box));
    if (interval.near > interval.far) continue;
    ++met;
    hit += bool(trace_all(geometry, ray));
  }
  REQUIRE(met > 10000);
  return double(hit) / met;
}

Candidate child(int name, double half_area, float occlusion, float cost) {
  return {.binary = std::uint32_t(name), .ref = {}, .half_area = half_area, .prospect = {occlusion, cost}};
}

}  // namespace

TEST_CASE("a line that intersects a block's box crosses its triangles as often as their area says") {
  Mesh mesh;
  add_triangle(mesh, {-0.5f, -0.4f, 0.2f}, {0.7f, -0.3f, -0.3f}, {0.1f, 0.6f, 0.5f});
  const Geometry geometry({mesh});
  const Aabb box = geometry.bounds();
  const PrimitiveBlock block = make_block(geometry, std::vector<PrimitiveId>{{0, 0}});
  const float occlusion = prospect_of(geometry, block, box.half_area()).occlusion;
  // One triangle is crossed once at most: the mean number of crossings is the share of hits.
  const double crossings = double(occlusion) / (1 - double(occlusion));
  constexpr double tolerance = 0.01;  // Five standard deviations.
  CHECK_THAT(crossings, Catch::Matchers::WithinAbs(share_of_hits(geometry, box), tolerance));
}

TEST_CASE("a sphere's prospect is about what lines through its box find") {
  const Geometry geometry({SphereSet{.spheres = {{{0, 0, 0}, 0.8f}}}});
  const PrimitiveBlock block = make_block(geometry, std::vector<PrimitiveId>{{0, 0}});
  const Prospect prospect = prospect_of(geometry, block, geometry.bounds().half_area());
  CHECK(prospect.occlusion > 0.25f);
  CHECK(prospect.occlusion < share_of_hits(geometry, geometry.bounds()) + 0.01);
}

TEST_CASE("blocks without area, and boxes without, end no query and cost what a block costs") {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  const Geometry geometry({mesh});
  const PrimitiveBlock block = make_block(geometry, std::vector<PrimitiveId>{{0, 0}});
  CHECK(prospect_of(geometry, block, 1).occlusion == 0);
  CHECK(prospect_of(geometry, block, 0).occlusion == 0);
  CHECK(prospect_of(geometry, block, 0).cost > 0);
}

TEST_CASE("a node's prospect follows from its children's, in their order") {
  const Candidate children[] = {child(0, 2, 0.5f, 1), child(1, 1, 1, 3)};
  const Prospect prospect = prospect_of(children, 4);
  // Half of the rays intersect the first, which stops half of them; a quarter of those that go on intersect
  // the second.
  CHECK(prospect.cost == 1 + 0.5f * 1 + 0.75f * 0.25f * 3);
  CHECK(prospect.occlusion == 1 - 0.75f * 0.75f);
  CHECK(prospect_of(children, 0).occlusion == 1);  // Inside of a box without area every child is intersected.
}

TEST_CASE("the child that ends a query for the least cost comes first, of equals the larger one") {
  Candidate children[] = {child(0, 1, 0.1f, 1), child(1, 1, 0.9f, 6), child(2, 1, 0.8f, 1),
                          child(3, 4, 0.8f, 1)};
  sort_for_occlusion(children);
  CHECK(children[0].binary == 3);
  CHECK(children[1].binary == 2);
  CHECK(children[2].binary == 1);
  CHECK(children[3].binary == 0);
}
