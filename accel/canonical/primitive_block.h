// SPDX-License-Identifier: Apache-2.0
// Private: the leaf that the hand-written BVHs and Embree share: up to four primitives, and their test by the
// plain canonical functions. block_test-inl.h has the fast one.
#pragma once
#include <cstdint>
#include <span>

#include "accel/canonical/shape_test.h"

namespace twinray {

/// Up to four primitives: the corners of triangles as a structure of arrays, everything else by its ids.
struct alignas(64) PrimitiveBlock {
  static constexpr int width = 4;

  float corners[3][3][width] = {};  ///< [corner][axis][lane]; zero in lanes without a triangle.
  PrimitiveId ids[width] = {};
  std::uint32_t count = 0;  ///< Lanes in use, from lane 0 on.
  /// Bit i: lane i is a triangle with an area, for which is_within_box() need not be asked.
  std::uint32_t triangles = 0;
  std::uint32_t others = 0;  ///< Bit i: lane i is anything else that can be hit.

  Vec3 corner(int index, int lane) const {
    return {corners[index][0][lane], corners[index][1][lane], corners[index][2][lane]};
  }
};
static_assert(sizeof(PrimitiveBlock) == 192, "three cache lines");

/// The block of up to four primitives of a geometry.
inline PrimitiveBlock make_block(const Geometry& geometry, std::span<const PrimitiveId> ids) {
  PrimitiveBlock block;
  for (const PrimitiveId id : ids) {
    const std::uint32_t lane = block.count++;
    block.ids[lane] = id;
    const Mesh* mesh = geometry.mesh(id.mesh);
    if (!mesh) {
      block.others |= 1u << lane;
      continue;
    }
    const auto [a, b, c] = mesh->triangles[id.primitive];
    const Vec3 corners[3] = {mesh->positions[a], mesh->positions[b], mesh->positions[c]};
    if (!has_area(corners[0], corners[1], corners[2])) continue;
    const Aabb box = triangle_bounds(corners[0], corners[1], corners[2]);
    const bool is_proved = std::max(max_abs(box.lower), max_abs(box.upper)) >= min_proved_size;
    (is_proved ? block.triangles : block.others) |= 1u << lane;
    for (int corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis) block.corners[corner][axis][lane] = corners[corner][axis];
  }
  return block;
}

/// The box of a block's primitives.
inline Aabb block_bounds(const Geometry& geometry, const PrimitiveBlock& block) {
  Aabb box;
  for (std::uint32_t lane = 0; lane < block.count; ++lane)
    box.extend(primitive_bounds(geometry, block.ids[lane]));
  return box;
}

/// What a query asks for.
enum class QueryKind { closest, any };

/// Tests the primitives of a block, one after the other, against [ray.t_min, best.t] and keeps the least hit;
/// QueryKind::any ends with the first.
template <QueryKind kind>
inline void test_block(const Geometry& geometry, const CheckedRay& ray, const PrimitiveBlock& block,
                       Hit& best) {
  for (std::uint32_t lane = 0; lane < block.count; ++lane) {
    test_primitive(geometry, ray, block.ids[lane], best);
    if (kind == QueryKind::any && best) return;
  }
}

}  // namespace twinray
