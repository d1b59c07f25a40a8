// SPDX-License-Identifier: Apache-2.0
// Private: the test of a block, its triangles in all lanes at once and its spheres likewise, compiled once
// for each instruction set by the files that include it (Highway's foreach_target).
//
// Of a triangle each step has the bits of accel/canonical/triangle.h. Vertices are sheared in float; from
// there on everything is double, in which the product of two floats is exact: so there is no error bound to
// reject by, a fused multiply-subtract of two such products has the bits of separate steps, and no lane is
// looked at twice. What triangle.h asks last, is_within_box(), is true by the choice of
// PrimitiveBlock::triangles.
#if defined(TWINRAY_ACCEL_BLOCK_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_BLOCK_TEST_INL_H
#undef TWINRAY_ACCEL_BLOCK_TEST_INL_H
#else
#define TWINRAY_ACCEL_BLOCK_TEST_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/block_lanes-inl.h"
#include "accel/canonical/edge_lanes-inl.h"
#include "accel/canonical/sphere_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A ray in the form that the block test needs: its shear, and its origin turned as the shear turns it, in
/// lanes.
class BlockRay : BlockLanes {
 public:
  HWY_ATTR HWY_INLINE explicit BlockRay(const CheckedRay& ray)
      : ox_(hn::Set(Floats(), ray.turned_origin[0])),
        oy_(hn::Set(Floats(), ray.turned_origin[1])),
        oz_(hn::Set(Floats(), ray.turned_origin[2])),
        sx_(hn::Set(Floats(), ray.shear[0])),
        sy_(hn::Set(Floats(), ray.shear[1])),
        sz_(hn::Set(Floats(), ray.shear[2])),
        x_row_(row(ray.axes[0])),
        y_row_(row(ray.axes[1])),
        z_row_(row(ray.axes[2])) {}

  /// Tests a block's primitives against [ray.t_min, the lesser of ray.t_max and best.t]; keeps the least hit.
  HWY_ATTR HWY_INLINE void closest(const Geometry& geometry, const CheckedRay& ray,
                                   const PrimitiveBlock& block, Nearest& best) const {
    if (block.triangles) closest_triangle(ray, block, best);
    if (block.spheres) closest_sphere(ray, block, best);
    if (block.others) closest_other(geometry, ray, block, best);
  }

  /// Whether a primitive of the block is hit in [ray.t_min, ray.t_max].
  HWY_ATTR HWY_INLINE bool any(const Geometry& geometry, const CheckedRay& ray,
                               const PrimitiveBlock& block) const {
    return (block.triangles && any_triangle(ray, block)) || (block.spheres && any_sphere(ray, block)) ||
           (block.others && any_other(geometry, ray, block, others_to_test(ray, block, ray.t_max)));
  }

 private:
  static HWY_ATTR HWY_INLINE std::size_t row(int axis) { return std::size_t(axis) * PrimitiveBlock::width; }

  HWY_ATTR HWY_INLINE void closest_triangle(const CheckedRay& ray, const PrimitiveBlock& block,
                                            Nearest& best) const {
    for (std::size_t first = 0; first < PrimitiveBlock::width; first += lane_count) {
      const Edges edges(*this, block, first);
      const std::uint32_t met = edges.met(block.triangles, first);
      if (met == 0) continue;
      const DoubleLanes determinant = edges.determinant();
      const FloatLanes t = edges.t(*this, determinant);
      const std::uint32_t hits =
          met & within(t, ray.t_min, std::min(ray.t_max, best.t)) & is_not_zero(determinant);
      if (hits != 0) keep(block, first, hits, t, {edges.b, edges.c, determinant}, best);
    }
  }

  HWY_ATTR HWY_INLINE bool any_triangle(const CheckedRay& ray, const PrimitiveBlock& block) const {
    for (std::size_t first = 0; first < PrimitiveBlock::width; first += lane_count) {
      const Edges edges(*this, block, first);
      // A branch on whether any is hit would be mispredicted: to go on is 7 % faster in batches.
      const std::uint32_t met = edges.met(block.triangles, first);
      const DoubleLanes determinant = edges.determinant();
      if (met & within(edges.t(*this, determinant), ray.t_min, ray.t_max) & is_not_zero(determinant))
        return true;
    }
    return false;
  }

  /// Of a block's others, those that must be asked one by one: of cut-outs, those that are hit at t_max or
  /// before. It makes lanes of its own: if it took these, all queries would have to keep them in memory.
  static HWY_ATTR HWY_NOINLINE std::uint32_t others_to_test(const CheckedRay& ray,
                                                            const PrimitiveBlock& block, float t_max) {
    std::uint32_t lanes = block.others & ~std::uint32_t(block.cut_outs);
    if (block.cut_outs == 0) return lanes;
    const BlockRay block_ray(ray);
    for (std::size_t first = 0; first < PrimitiveBlock::width; first += lane_count) {
      const Edges edges(block_ray, block, first);
      const DoubleLanes determinant = edges.determinant();
      const FloatLanes t = edges.t(block_ray, determinant);
      const std::uint32_t hits =
          edges.met(block.cut_outs, first) & within(t, ray.t_min, t_max) & is_not_zero(determinant);
      lanes |= hits << first;
    }
    return lanes;
  }

  static HWY_ATTR HWY_NOINLINE void closest_other(const Geometry& geometry, const CheckedRay& ray,
                                                  const PrimitiveBlock& block, Nearest& best) {
    const std::uint32_t lanes = others_to_test(ray, block, std::min(ray.t_max, best.t));
    if (lanes != 0) best.test(geometry, ray, block, lanes);
  }

  static HWY_ATTR HWY_INLINE void closest_sphere(const CheckedRay& ray, const PrimitiveBlock& block,
                                                 Nearest& best) {
    for (std::size_t first = 0; first < PrimitiveBlock::width; first += lane_count) {
      if (lane_count < PrimitiveBlock::width && some_of(block.spheres, first) == 0) continue;
      const SphereChords chords(ray, block, first);
      if (chords.met() == 0) continue;
      FloatLanes t;
      DoubleLanes normal[3];
      const std::uint32_t hits = chords.hits(ray, block, first, std::min(ray.t_max, best.t), t, normal);
      if (hits != 0) keep(block, first, hits, t, normal, best);
    }
  }

  static HWY_ATTR HWY_INLINE bool any_sphere(const CheckedRay& ray, const PrimitiveBlock& block) {
    for (std::size_t first = 0; first < PrimitiveBlock::width; first += lane_count) {
      if (lane_count < PrimitiveBlock::width && some_of(block.spheres, first) == 0) continue;
      const SphereChords chords(ray, block, first);
      if (chords.met() == 0) continue;  // Without this branch 7 % slower.
      FloatLanes t;
      DoubleLanes normal[3];
      if (chords.hits(ray, block, first, ray.t_max, t, normal)) return true;
    }
    return false;
  }

  /// The sheared corners of lane_count triangles, before z is scaled.
  struct Corners {
    DoubleLanes x[3], y[3];
    FloatLanes z[3];

    HWY_ATTR HWY_INLINE Corners(const BlockRay& ray, const PrimitiveBlock& block, std::size_t first) {
      for (int corner = 0; corner < 3; ++corner) {
        const auto* const rows = reinterpret_cast<const float*>(&block.corners[corner]) + first;
        z[corner] = hn::Sub(hn::Load(Floats(), rows + ray.z_row_), ray.oz_);
        x[corner] = sheared(hn::Sub(hn::Load(Floats(), rows + ray.x_row_), ray.ox_), ray.sx_, z[corner]);
        y[corner] = sheared(hn::Sub(hn::Load(Floats(), rows + ray.y_row_), ray.oy_), ray.sy_, z[corner]);
      }
    }
    static HWY_ATTR HWY_INLINE DoubleLanes sheared(FloatLanes x, FloatLanes slope, FloatLanes z) {
      return hn::PromoteTo(Doubles(), hn::Sub(x, hn::Mul(slope, z)));
    }
  };

  /// Their edge functions.
  class Edges : public EdgeLanes<Doubles> {
   public:
    HWY_ATTR HWY_INLINE Edges(const BlockRay& ray, const PrimitiveBlock& block, std::size_t first)
        : Edges(Corners(ray, block, first)) {}

    /// Bit i: the ray's line intersects triangle i of those named, or sees it edge-on.
    HWY_ATTR HWY_INLINE std::uint32_t met(std::uint32_t triangles, std::size_t first) const {
      return ~bits_of(Doubles(), this->are_beside()) & some_of(triangles, first);
    }
    HWY_ATTR HWY_INLINE FloatLanes t(const BlockRay& ray, DoubleLanes determinant) const {
      const DoubleLanes sum = this->weighted(ray.scaled(z_[0]), ray.scaled(z_[1]), ray.scaled(z_[2]));
      return hn::DemoteTo(Floats(), hn::Div(sum, determinant));
    }

   private:
    HWY_ATTR HWY_INLINE explicit Edges(const Corners& corners)
        : EdgeLanes<Doubles>(corners.x, corners.y), z_{corners.z[0], corners.z[1], corners.z[2]} {}

    FloatLanes z_[3];
  };

  HWY_ATTR HWY_INLINE DoubleLanes scaled(FloatLanes z) const {
    return hn::PromoteTo(Doubles(), hn::Mul(sz_, z));
  }
  static HWY_ATTR HWY_INLINE std::uint32_t is_not_zero(DoubleLanes determinant) {
    return bits_of(Doubles(), hn::Ne(determinant, hn::Zero(Doubles())));
  }

  FloatLanes ox_, oy_, oz_, sx_, sy_, sz_;
  std::size_t x_row_, y_row_, z_row_;  ///< Where in a corner's rows the ray's axes are.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
