// SPDX-License-Identifier: Apache-2.0
// Private: the leaf that the hand-written BVHs and Embree share: up to four primitives, and their test by the
// plain canonical functions. block_test-inl.h has the fast one.
#pragma once
#include <cstdint>
#include <span>

#include "accel/canonical/shape_test.h"

namespace twinray {

/// Up to four primitives as structures of arrays: 48 bytes for each lane, whatever it holds.
struct alignas(64) PrimitiveBlock {
  static constexpr int width = 4;

  /// [corner][axis][lane]. Of a sphere the first corner is its centre, and the second holds its radius and
  /// the padding of its box. Zero in lanes without a primitive.
  float corners[3][3][width] = {};
  PrimitiveId ids[width] = {};
  std::uint16_t count = 0;  ///< Lanes in use, from lane 0 on.
  /// Bit i: lane i is one of `others` for its shape alone, which is not opaque, and else were of `triangles`.
  std::uint16_t cut_outs = 0;
  /// Bit i: lane i is a triangle with an area, for which is_within_box() need not be asked.
  std::uint32_t triangles = 0;
  std::uint32_t spheres = 0;  ///< Bit i: lane i is a sphere with a radius.
  std::uint32_t others = 0;   ///< Bit i: lane i is anything else that can be hit.

  Vec3 corner(int index, int lane) const {
    return {corners[index][0][lane], corners[index][1][lane], corners[index][2][lane]};
  }
  /// Of the lanes' spheres; of their boxes, how far padded() moves each plane.
  const float* radii() const { return corners[1][0]; }
  const float* paddings() const { return corners[1][1]; }
  bool is_sphere(int lane) const { return (spheres >> lane & 1) != 0; }

  void set_corner(int index, std::uint32_t lane, const Vec3& corner) {
    for (int axis = 0; axis < 3; ++axis) corners[index][axis][lane] = corner[axis];
  }
  void set_triangle(std::uint32_t lane, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!has_area(a, b, c)) return;
    const Aabb box = triangle_bounds(a, b, c);
    const bool is_proved = std::max(max_abs(box.lower), max_abs(box.upper)) >= min_proved_size;
    (is_proved ? triangles : others) |= 1u << lane;
    set_corner(0, lane, a);
    set_corner(1, lane, b);
    set_corner(2, lane, c);
  }
  void set_sphere(std::uint32_t lane, const Sphere& sphere) {
    if (!(sphere.radius > 0)) return;
    spheres |= 1u << lane;
    set_corner(0, lane, sphere.center);
    set_corner(1, lane, {sphere.radius, padding_of(sphere_bounds(sphere)), 0});
  }
  /// Not every hit of the lane's primitive counts.
  void set_cut_out(std::uint32_t lane) {
    const std::uint32_t bit = 1u << lane;
    cut_outs = std::uint16_t(cut_outs | (triangles & bit));
    others |= (triangles | spheres) & bit;
    triangles &= ~bit;
    spheres &= ~bit;
  }
};
static_assert(sizeof(PrimitiveBlock) == 192, "three cache lines");

/// The block of up to four primitives of a geometry.
inline PrimitiveBlock make_block(const Geometry& geometry, std::span<const PrimitiveId> ids) {
  PrimitiveBlock block;
  for (const PrimitiveId id : ids) {
    const std::uint32_t lane = block.count++;
    block.ids[lane] = id;
    if (const Mesh* mesh = geometry.mesh(id.mesh)) {
      const auto [a, b, c] = mesh->triangles[id.primitive];
      block.set_triangle(lane, mesh->positions[a], mesh->positions[b], mesh->positions[c]);
    } else {
      block.set_sphere(lane, geometry.sphere_set(id.mesh)->spheres[id.primitive]);
    }
    if (!geometry.is_opaque(id.mesh)) block.set_cut_out(lane);
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
