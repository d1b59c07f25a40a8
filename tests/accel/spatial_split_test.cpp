// SPDX-License-Identifier: Apache-2.0
// Trees whose leaves hold pieces of primitives.
#include <algorithm>
#include <cmath>

#include "accel/bvh/build.h"
#include "accel/bvh/invariants.h"
#include "accel/canonical/checked_ray.h"
#include "accel/canonical/slab.h"
#include "tests/support/catch.h"
#include "tests/support/hostile.h"
#include "tests/support/shapes.h"

using namespace twinray;
using namespace twinray::test;

#ifdef TWINRAY_WITH_EMBREE
namespace {

Bvh build_split(const Geometry& geometry, int max_leaf_size) {
  std::vector<BuildPhase> phases;
  return make_bvh(geometry,
                  {.bvh_width = 2, .bvh_builder = BvhBuilder::embree_high, .max_leaf_size = max_leaf_size},
                  phases);
}

bool same(PrimitiveId a, PrimitiveId b) { return a.mesh == b.mesh && a.primitive == b.primitive; }

}  // namespace

TEST_CASE("embree-high lays large primitives into several leaves, and none twice into one") {
  const auto geometry = share({soup(300, 0.05f, 23), soup(10, 2, 24)});
  for (const int leaf : {1, 4, 32}) {
    const Bvh bvh = build_split(*geometry, leaf);
    int pieces = 0, of_large = 0;
    for (const PrimitiveBlock& block : bvh.blocks)
      for (std::uint32_t lane = 0; lane < block.count; ++lane) {
        ++pieces;
        of_large += block.ids[lane].mesh == 1;
        for (std::uint32_t other = 0; other < lane; ++other)
          CHECK_FALSE(same(block.ids[lane], block.ids[other]));
      }
    CHECK(pieces <= 2 * 310);
    CHECK(of_large > 10);
  }
}

TEST_CASE("every leaf of a tree of pieces is needed") {
  const auto geometry = share({soup(100, 0.05f, 25), soup(10, 2, 26)});
  const Bvh good = build_split(*geometry, 1);
  REQUIRE(find_fault(good, *geometry, 1, Occurrence::in_pieces) == "");
  CHECK(find_fault(good, *geometry, 1).find(" leaves") != std::string::npos);
  for (std::size_t i = 0; i < good.blocks.size(); ++i) {
    Bvh bad = good;  // with another primitive in the place of this piece
    bad.blocks[i].ids[0] = {0, same(good.blocks[i].ids[0], {0, 0}) ? 1u : 0u};
    CHECK(find_fault(bad, *geometry, 1, Occurrence::in_pieces) != "");
  }
}
#endif

TEST_CASE("a hit's parameter lies in one of the two parts of its box, at any plane") {
  // What the pieces of embree-high rest on (accel/embree/builder.cpp).
  Random random(27);
  int inside = 0;
  for (int i = 0; i < 200000; ++i) {
    CheckedRay ray;
    const HostilePair pair = hostile_pair(random);
    if (!load_ray(pair.ray, ray)) continue;
    const Aabb box = padded(triangle_bounds(pair.corners[0], pair.corners[1], pair.corners[2]));
    const SlabInterval whole = intersect_slab(ray, box);
    if (!(whole.near <= whole.far && whole.far >= 0)) continue;
    const int axis = random.below(3);
    Aabb first = box, second = box;
    first.upper[axis] = second.lower[axis] =
        std::clamp(box.lower[axis] + random.unit() * (box.upper[axis] - box.lower[axis]), box.lower[axis],
                   box.upper[axis]);
    const SlabInterval a = intersect_slab(ray, first), b = intersect_slab(ray, second);
    const auto is_in = [](const SlabInterval& interval, float t) {
      return interval.near <= t && t <= interval.far;
    };
    // Ends of the intervals, and their neighbours, are where a gap would be.
    for (const float t : {whole.near, whole.far, a.near, a.far, b.near, b.far})
      for (const float at : {std::nextafter(t, -INFINITY), t, std::nextafter(t, INFINITY)})
        if (at >= 0 && is_in(whole, at)) {
          ++inside;
          REQUIRE((is_in(a, at) || is_in(b, at)));
        }
  }
  CHECK(inside > 100000);
}
TEST_CASE("a box is covered by boxes that share the planes between them") {
  const Aabb box{{0, 0, 0}, {4, 1, 1}};
  const auto part = [](float from, float to) { return Aabb{{from, 0, 0}, {to, 1, 1}}; };
  CHECK(is_covered(box, std::vector{box}));
  CHECK(is_covered(box, std::vector{part(0, 1), part(1, 3), part(3, 4)}));
  CHECK(is_covered(box, std::vector{part(-1, 2), part(1, 5)}));
  CHECK_FALSE(is_covered(box, std::vector<Aabb>{}));
  CHECK_FALSE(is_covered(box, std::vector{part(0, 1), part(std::nextafter(1.0f, 2.0f), 4)}));
  CHECK_FALSE(is_covered(box, std::vector{part(0, 1), part(3, 4)}));
  CHECK_FALSE(is_covered(box, std::vector{part(0, 3)}));
  const Aabb corner{{0, 0, 0}, {2, 0.5f, 1}}, above{{0, 0.5f, 0}, {2, 1, 1}};
  CHECK(is_covered(box, std::vector{corner, above, part(2, 4)}));
  CHECK_FALSE(is_covered(box, std::vector{corner, part(2, 4)}));
}
