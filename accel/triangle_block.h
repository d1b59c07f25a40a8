// SPDX-License-Identifier: Apache-2.0
// Private: the leaf that the hand-written BVH and Embree share.
//
// A block holds up to four primitives. Filter, then confirm: a branch-free filter runs over the four lanes at
// once and rejects what the canonical test would reject by the signs of its edge functions or by t; each lane
// left is confirmed by the canonical test itself. So a block gives canonical bits by construction, whatever
// the filter lets through, as long as it never rejects what the canonical test accepts.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "accel/lanes.h"
#include "accel/shape_test.h"

namespace twinray {

/// Up to four primitives: the corners of triangles as a structure of arrays, everything else by its ids.
struct alignas(64) TriangleBlock {
  static constexpr int width = 4;

  float corners[3][3][width] = {};  ///< [corner][axis][lane]; zero in lanes without a triangle.
  PrimitiveId ids[width] = {};
  std::uint32_t count = 0;      ///< Lanes in use, from lane 0 on.
  std::uint32_t triangles = 0;  ///< Bit i: lane i is a triangle with an area.

  Vec3 corner(int index, int lane) const {
    return {corners[index][0][lane], corners[index][1][lane], corners[index][2][lane]};
  }
  Aabb bounds(int lane) const { return triangle_bounds(corner(0, lane), corner(1, lane), corner(2, lane)); }
  std::uint32_t lanes() const { return (1u << count) - 1; }
};
static_assert(sizeof(TriangleBlock) == 192, "three cache lines");

/// The block of up to four primitives of a geometry.
inline TriangleBlock make_block(const Geometry& geometry, std::span<const PrimitiveId> ids) {
  TriangleBlock block;
  for (const PrimitiveId id : ids) {
    const std::uint32_t lane = block.count++;
    block.ids[lane] = id;
    const Mesh* mesh = geometry.mesh(id.mesh);
    if (!mesh) continue;
    const auto [a, b, c] = mesh->triangles[id.primitive];
    const Vec3 corners[3] = {mesh->positions[a], mesh->positions[b], mesh->positions[c]};
    if (!has_area(corners[0], corners[1], corners[2])) continue;
    block.triangles |= 1u << lane;
    for (int corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis) block.corners[corner][axis][lane] = corners[corner][axis];
  }
  return block;
}

/// The box of a block's primitives.
inline Aabb block_bounds(const Geometry& geometry, const TriangleBlock& block) {
  Aabb box;
  for (std::uint32_t lane = 0; lane < block.count; ++lane)
    box.extend(primitive_bounds(geometry, block.ids[lane]));
  return box;
}

/// What a block's test needs of a ray, in every lane: its shear, and its origin turned as the shear turns it.
struct LaneRay {
  Float4 ox, oy, oz, sx, sy, sz;
  int kx, ky, kz;

  explicit LaneRay(const CheckedRay& ray)
      : sx(splat(ray.sx)), sy(splat(ray.sy)), sz(splat(ray.sz)), kx(ray.kx), ky(ray.ky), kz(ray.kz) {
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    ox = splat(origin[kx]);
    oy = splat(origin[ky]);
    oz = splat(origin[kz]);
  }
};

/// The corners of all lanes in the ray's frame: the bits of shear().
struct ShearedLanes {
  Float4 x[3], y[3], z[3];

  ShearedLanes(const LaneRay& ray, const TriangleBlock& block) {
    for (int corner = 0; corner < 3; ++corner) {
      z[corner] = load(block.corners[corner][ray.kz]) - ray.oz;
      x[corner] = (load(block.corners[corner][ray.kx]) - ray.ox) - ray.sx * z[corner];
      y[corner] = (load(block.corners[corner][ray.ky]) - ray.oy) - ray.sy * z[corner];
      z[corner] = ray.sz * z[corner];
    }
  }
  ShearedVertex corner(int index, int lane) const { return {x[index][lane], y[index][lane], z[index][lane]}; }
};

/// The float edge functions of all lanes, and the bound of their rounding errors: the bits of
/// EdgeFunctions<float> and edge_error().
struct LaneEdges {
  Float4 a, b, c, error;

  explicit LaneEdges(const ShearedLanes& lanes) {
    const Float4 *const x = lanes.x, *const y = lanes.y;
    a = x[2] * y[1] - y[2] * x[1];
    b = x[0] * y[2] - y[0] * x[2];
    c = x[1] * y[0] - y[1] * x[0];
    const Float4 largest_x = max(abs(x[0]), max(abs(x[1]), abs(x[2])));
    const Float4 largest_y = max(abs(y[0]), max(abs(y[1]), abs(y[2])));
    error = edge_margin * (largest_x * largest_y) + edge_underflow;
  }
  /// The lanes of triangles beside the ray: is_beside() of each.
  Int4 beside() const { return (min(a, min(b, c)) < -error) & (max(a, max(b, c)) > error); }
};

/// On which side of a given t the lanes' canonical hits are, if they have any.
///
/// A hit's t is T / D, with D the sum of the edge functions and T that of their products with z; t lies
/// before `limit` where the sum of the products with z - limit has the sign against D. With u = 2^-24 and m
/// the largest |x| times the largest |y|, LaneEdges::error is at least 8 u m, an edge function is off by half
/// of that and at most 2 m. So the float D is off by at most 3 * 4 u m and 10 u m for two sums; the other
/// sum, by 3 * 4 u m, 3 * 4 u m for differences and products and 10 u m for two sums, times the largest |z -
/// limit|: both by less than 5 errors. Beyond that the t of a rejected hit must stand apart from `limit` by
/// more than its own rounding.
struct LaneDepths {
  Float4 distance;  ///< (t - limit) |D|
  Float4 error;
  Int4 is_certain;  ///< Whether the sign of D is.

  // 2^-80 keeps t apart from zero and, unlike the least normal number, costs no denormal products: 8 %.
  LaneDepths(const ShearedLanes& lanes, const LaneEdges& edges, float limit) {
    const Float4 x = lanes.z[0] - limit, y = lanes.z[1] - limit, z = lanes.z[2] - limit;
    constexpr std::int32_t sign_bit = std::numeric_limits<std::int32_t>::min();
    const Float4 determinant = edges.a + edges.b + edges.c;
    const Float4 sum = edges.a * x + edges.b * y + edges.c * z;
    distance = Float4(Int4(sum) ^ (Int4(determinant) & sign_bit));
    const Float4 margin = 5.0f * edges.error;
    const float rounding = 0x1p-23f * limit + 0x1p-80f;
    error = margin * max(abs(x), max(abs(y), abs(z))) + rounding * abs(determinant) + edge_underflow;
    is_certain = (abs(determinant) > margin) & (abs(sum) <= std::numeric_limits<float>::max());
  }
  /// Lanes surely not hit at `limit` or beyond, and at `limit` or before.
  Int4 before() const { return is_certain & (distance < -error); }
  Int4 beyond() const { return is_certain & (distance > error); }
};

/// What a query asks for.
enum class QueryKind { closest, any };

/// Bit i: the canonical test may accept lane i in [ray.t_min, ray.t_max]. The line of a bounce or shadow ray
/// passes through the triangle on which the ray starts, and often through its neighbours, just before t_min;
/// that of a shadow ray through the light just beyond t_max.
template <QueryKind kind>
inline std::uint32_t filter_lanes(const CheckedRay& ray, const ShearedLanes& lanes,
                                  const TriangleBlock& block) {
  const LaneEdges edges(lanes);
  const std::uint32_t met = (~mask_bits(edges.beside()) | ~block.triangles) & block.lanes();
  // Few blocks come further: without this line a million triangles took 3 % longer.
  if (met == 0) return 0;
  Int4 rejected = LaneDepths(lanes, edges, ray.t_min).before();
  if constexpr (kind == QueryKind::any) rejected |= LaneDepths(lanes, edges, ray.t_max).beyond();
  return met & (~mask_bits(rejected) | ~block.triangles);
}

/// test_primitive(), out of the way of the triangles' code.
[[gnu::noinline, gnu::cold]] inline void test_other(const Geometry& geometry, const CheckedRay& ray,
                                                    PrimitiveId id, Hit& best) {
  test_primitive(geometry, ray, id, best);
}

/// Tests one lane by what is left of the canonical test and keeps the lesser hit.
inline void confirm_lane(const Geometry& geometry, const CheckedRay& ray, const ShearedLanes& lanes,
                         const TriangleBlock& block, int lane, Hit& best) {
  const PrimitiveId id = block.ids[lane];
  if (!(block.triangles >> lane & 1)) return test_other(geometry, ray, id, best);
  ShapeHit found;
  if (!intersect_sheared(ray, lanes.corner(0, lane), lanes.corner(1, lane), lanes.corner(2, lane),
                         std::min(ray.t_max, best.t), found) ||
      !is_within_box(ray, block.bounds(lane), found.t))
    return;
  const Hit hit{found.t, found.u, found.v, id.primitive, id.mesh, no_instance};
  if (precedes(hit, best)) best = hit;
}

/// Tests the primitives of a block against [ray.t_min, best.t] and keeps the least hit; QueryKind::any ends
/// with the first.
template <QueryKind kind, TriangleTest test = TriangleTest::woop>
inline void test_block(const Geometry& geometry, const CheckedRay& ray, const LaneRay& lane_ray,
                       const TriangleBlock& block, Hit& best) {
  if constexpr (test == TriangleTest::woop) {
    const ShearedLanes lanes(lane_ray, block);
    for (std::uint32_t left = filter_lanes<kind>(ray, lanes, block); left != 0; left &= left - 1) {
      confirm_lane(geometry, ray, lanes, block, std::countr_zero(left), best);
      if (kind == QueryKind::any && best) return;
    }
  } else {
    for (std::uint32_t lane = 0; lane < block.count; ++lane)
      test_primitive<test>(geometry, ray, block.ids[lane], best);
  }
}

}  // namespace twinray
