// SPDX-License-Identifier: Apache-2.0
// The fast tests of a block against the plain canonical one, for every instruction set of this machine: a
// tree of one block is asked.
#pragma once
#include <bit>
#include <vector>

#include "accel/wide/kernel.h"
#include "tests/support/catch.h"

namespace twinray::test {

/// How often an answer was a hit, and how often none.
struct Tally {
  int hits = 0, misses = 0;
};

/// Bit for bit, unlike ==, by which 0 is -0. Misses are alike.
inline bool has_same_bits(const Hit& a, const Hit& b) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  if (!a || !b) return !a && !b;
  return a == b && bits(a.t) == bits(b.t) && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

/// The answer of the plain test, primitive after primitive; an invalid ray is a miss.
inline Hit canonical_hit(const Geometry& geometry, const PrimitiveBlock& block, const Ray& ray) {
  CheckedRay loaded;
  Hit best;
  if (!load_ray(ray, loaded)) return best;
  test_block<QueryKind::closest>(geometry, loaded, block, best);
  loaded.scale_back(best);
  return best;
}

/// Asks every kernel about one block, in each of its ways, and fails where one differs from the plain test.
inline void compare(const Geometry& geometry, const std::vector<PrimitiveId>& ids, const Ray& ray,
                    Tally& tally) {
  static const std::vector<WideKernel> kernels = wide_kernels();
  const WideBvh bvh{.root = WideRef::block(0), .nodes = {}, .blocks = {make_block(geometry, ids)}};
  const Hit expected = canonical_hit(geometry, bvh.blocks[0], ray);
  (expected ? tally.hits : tally.misses) += 1;
  for (const WideKernel& kernel : kernels) {
    CAPTURE(kernel.name);
    if (!has_same_bits(kernel.closest(bvh, geometry, ray), expected)) FAIL("the closest hit differs");
    if (kernel.any(bvh, geometry, ray) != bool(expected)) FAIL("whether there is a hit differs");
    for (const auto closest : {kernel.closest_in_turn, kernel.closest_batch}) {
      Hit hit;
      closest(bvh, geometry, {&ray, 1}, &hit);
      if (!has_same_bits(hit, expected)) FAIL("the closest hit of one of many rays differs");
    }
    for (const auto any : {kernel.any_in_turn, kernel.any_batch}) {
      std::uint8_t is_hit = 2;
      any(bvh, geometry, {&ray, 1}, &is_hit);
      if (is_hit != std::uint8_t(bool(expected))) FAIL("whether one of many rays has a hit differs");
    }
  }
}

}  // namespace twinray::test
