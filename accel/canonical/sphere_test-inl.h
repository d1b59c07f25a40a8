// SPDX-License-Identifier: Apache-2.0
// Private: the test of the spheres of a block, in all lanes at once, compiled once for each instruction set.
//
// Each lane does the steps of accel/canonical/sphere.h in their order and has its bits, with one step less:
// there the far root is looked at where the near one is not accepted, here where it lies before t_min. The
// roots are in order, also when they have been moved into the sphere's box; so if the near one lies behind
// t_max, the far one does, too.
#if defined(TWINRAY_ACCEL_SPHERE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_SPHERE_TEST_INL_H
#undef TWINRAY_ACCEL_SPHERE_TEST_INL_H
#else
#define TWINRAY_ACCEL_SPHERE_TEST_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "accel/canonical/block_lanes-inl.h"
#include "accel/canonical/checked_ray.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Where a ray enters and leaves the boxes of some spheres of a block, widened: intersect_slab() of padded()
/// of sphere_bounds().
class SphereBoxes : BlockLanes {
 public:
  HWY_ATTR HWY_INLINE SphereBoxes(const CheckedRay& ray, const PrimitiveBlock& block, std::size_t first)
      : radius_(hn::Load(Floats(), block.radii() + first)),
        padding_(hn::Load(Floats(), block.paddings() + first)) {
    const Axis x(*this, ray, block, first, 0), y(*this, ray, block, first, 1), z(*this, ray, block, first, 2);
    near_ = larger(x.near, larger(y.near, z.near));
    far_ = smaller(x.far, smaller(y.far, z.far));
  }
  /// Bit i: the ray intersects box i.
  HWY_ATTR HWY_INLINE std::uint32_t met() const { return bits_of(Floats(), hn::Le(near_, far_)); }
  /// The t in the box that is the nearest to a root's.
  HWY_ATTR HWY_INLINE FloatLanes clamped(FloatLanes t) const { return smaller(larger(t, near_), far_); }

 private:
  /// The planes of one axis that are near and far in the ray's direction, as parameters. A negative direction
  /// mirrors the axis: by its sign bit, as lanes without a sphere have denormal planes, a product of which
  /// takes an Intel processor fifty nanoseconds. By symmetry the lower plane, centre - radius rounded down
  /// and widened, is minus what radius - centre gives rounded up.
  struct Axis {
    FloatLanes near, far;

    HWY_ATTR HWY_INLINE Axis(const SphereBoxes& boxes, const CheckedRay& ray, const PrimitiveBlock& block,
                             std::size_t first, int axis) {
      const FloatLanes sign = hn::And(hn::Set(Floats(), ray.direction[axis]), hn::SignBit(Floats()));
      const FloatLanes center = hn::Xor(hn::Load(Floats(), block.corners[0][axis] + first), sign);
      const FloatLanes before = boxes.plane(hn::Sub(boxes.radius_, center));
      const FloatLanes behind = boxes.plane(hn::Add(boxes.radius_, center));
      near = hn::Mul(hn::Sub(hn::Neg(hn::Xor(before, sign)), hn::Set(Floats(), ray.near_origin[axis])),
                     hn::Set(Floats(), ray.near_inverse[axis]));
      far = hn::Mul(hn::Sub(hn::Xor(behind, sign), hn::Set(Floats(), ray.far_origin[axis])),
                    hn::Set(Floats(), ray.far_inverse[axis]));
    }
  };

  /// The next float above, and the padding. Not for -0, which no sum with a radius is.
  HWY_ATTR HWY_INLINE FloatLanes plane(FloatLanes x) const {
    const hn::RebindToSigned<Floats> ints;
    const auto bits = hn::BitCast(ints, x);
    const auto step = hn::Or(hn::ShiftRight<31>(bits), hn::Set(ints, 1));
    return hn::Add(hn::BitCast(Floats(), hn::Add(bits, step)), padding_);
  }
  /// std::max and std::min, which of equal numbers take the first: 0 and -0 are equal.
  static HWY_ATTR HWY_INLINE FloatLanes larger(FloatLanes a, FloatLanes b) {
    return hn::IfThenElse(hn::Lt(a, b), b, a);
  }
  static HWY_ATTR HWY_INLINE FloatLanes smaller(FloatLanes a, FloatLanes b) {
    return hn::IfThenElse(hn::Lt(b, a), b, a);
  }

  FloatLanes radius_, padding_, near_, far_;
};

/// A ray's line and some spheres of a block, from lane `first` on.
class SphereChords : BlockLanes {
 public:
  HWY_ATTR HWY_INLINE SphereChords(const CheckedRay& ray, const PrimitiveBlock& block, std::size_t first) {
    DoubleLanes origin[3];
    for (int axis = 0; axis < 3; ++axis) {
      const FloatLanes center = hn::Load(Floats(), block.corners[0][axis] + first);
      origin[axis] = hn::Sub(hn::Set(Doubles(), double(ray.origin[axis])), hn::PromoteTo(Doubles(), center));
      direction_[axis] = hn::Set(Doubles(), double(ray.direction[axis]));
    }
    squared_length_ = dot(direction_, direction_);
    closest_ = hn::Div(hn::Neg(dot(origin, direction_)), squared_length_);
    for (int axis = 0; axis < 3; ++axis)
      point_[axis] = hn::Add(origin[axis], hn::Mul(closest_, direction_[axis]));
    const DoubleLanes radius = hn::PromoteTo(Doubles(), hn::Load(Floats(), block.radii() + first));
    room_ = hn::Sub(hn::Mul(radius, radius), dot(point_, point_));
    met_ = some_of(block.spheres, first) & ~bits_of(Doubles(), hn::Lt(room_, hn::Zero(Doubles())));
  }
  /// Bit i: the line intersects sphere i.
  HWY_ATTR HWY_INLINE std::uint32_t met() const { return met_; }

  /// Bit i: sphere i is hit in [ray.t_min, t_max], at t; what u and v are made of is `normal`.
  HWY_ATTR HWY_INLINE std::uint32_t hits(const CheckedRay& ray, const PrimitiveBlock& block,
                                         std::size_t first, float t_max, FloatLanes& t,
                                         DoubleLanes (&normal)[3]) const {
    const DoubleLanes half_chord = hn::Sqrt(hn::Div(room_, squared_length_));
    const SphereBoxes boxes(ray, block, first);
    const FloatLanes near = boxes.clamped(hn::DemoteTo(Floats(), hn::Sub(closest_, half_chord)));
    const FloatLanes far = boxes.clamped(hn::DemoteTo(Floats(), hn::Add(closest_, half_chord)));
    const auto is_far = hn::Lt(near, hn::Set(Floats(), ray.t_min));
    t = hn::IfThenElse(is_far, far, near);
    const FloatLanes one = hn::Set(Floats(), 1.0f);
    const DoubleLanes side = hn::PromoteTo(Doubles(), hn::IfThenElse(is_far, one, hn::Neg(one)));
    const DoubleLanes along = hn::Mul(half_chord, side);
    for (int axis = 0; axis < 3; ++axis)
      normal[axis] = hn::Add(point_[axis], hn::Mul(along, direction_[axis]));
    return met_ & boxes.met() & within(t, ray.t_min, t_max);
  }

 private:
  static HWY_ATTR HWY_INLINE DoubleLanes dot(const DoubleLanes (&a)[3], const DoubleLanes (&b)[3]) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
  }

  DoubleLanes direction_[3], squared_length_;
  DoubleLanes closest_;   ///< Where the line is closest to the centre, in t.
  DoubleLanes point_[3];  ///< And that point, seen from the centre.
  DoubleLanes room_;      ///< The squared radius less that point's squared distance.
  std::uint32_t met_;
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
