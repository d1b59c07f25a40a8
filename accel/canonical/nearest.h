// SPDX-License-Identifier: Apache-2.0
// Private: the least hit of a closest-hit query so far, as the fast block test keeps it.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

#include "accel/canonical/primitive_block.h"

namespace twinray {

/// Of one space: of a scene's, or of an instance's. Of what is tested in lanes only its place is kept, and
/// what u and v are made of: the divisions wait for the end.
struct Nearest {
  float t = std::numeric_limits<float>::infinity();
  int lane = 0;
  const PrimitiveBlock* block = nullptr;  ///< Null where the hit is `other`.
  /// Of each lane. Of a triangle: the edge functions of the second and third corner, and the sum of all
  /// three. Of a sphere: the point that is hit, seen from the centre.
  alignas(32) double uv_terms[3][PrimitiveBlock::width];
  Hit other;  ///< A hit of something that is not tested in lanes, or none.

  /// As a hit of the ray.
  Hit hit(const CheckedRay& ray) const {
    if (!block) return other;
    const PrimitiveId id = block->ids[lane];
    const Vec2 uv = block->is_sphere(lane) ? octahedral_encode(term(0), term(1), term(2))
                                           : Vec2{float(term(0) / term(2)), float(term(1) / term(2))};
    return {t, uv.x, uv.y, id.primitive, id.mesh, ray.instance};
  }
  double term(int index) const { return uv_terms[index][lane]; }
  PrimitiveId id() const { return block ? block->ids[lane] : PrimitiveId{other.mesh, other.primitive}; }

  /// Tests some lanes of a block by the plain canonical test.
  [[gnu::noinline, gnu::cold]] void test(const Geometry& geometry, const CheckedRay& ray,
                                         const PrimitiveBlock& tested, std::uint32_t lanes) {
    const Hit before = hit(ray);
    Hit best = before;
    for (; lanes != 0; lanes &= lanes - 1)
      test_primitive(geometry, ray, tested.ids[std::countr_zero(lanes)], best);
    if (best == before) return;
    other = best;
    t = best.t;
    block = nullptr;
  }
};

/// Whether the ray hits one of some lanes of a block, by the plain canonical test.
[[gnu::noinline, gnu::cold]] inline bool any_other(const Geometry& geometry, const CheckedRay& ray,
                                                   const PrimitiveBlock& block, std::uint32_t lanes) {
  Hit found;
  for (std::uint32_t left = lanes; left != 0 && !found; left &= left - 1)
    test_primitive(geometry, ray, block.ids[std::countr_zero(left)], found);
  return bool(found);
}

/// Of some lanes of a block, the one whose hit precedes the others.
[[gnu::noinline, gnu::cold]] inline int least_lane(const PrimitiveBlock& block, std::uint32_t lanes,
                                                   const float t[PrimitiveBlock::width]) {
  int least = std::countr_zero(lanes);
  for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    if (t[lane] < t[least] || (t[lane] == t[least] && block.ids[lane] < block.ids[least])) least = lane;
  }
  return least;
}

}  // namespace twinray
