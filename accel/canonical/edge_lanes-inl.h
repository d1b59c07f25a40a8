// SPDX-License-Identifier: Apache-2.0
// Private: the edge functions of accel/canonical/triangle.h in lanes, of triangles or of rays, compiled once
// for each instruction set.
#if defined(TWINRAY_ACCEL_EDGE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_EDGE_LANES_INL_H
#undef TWINRAY_ACCEL_EDGE_LANES_INL_H
#else
#define TWINRAY_ACCEL_EDGE_LANES_INL_H
#endif

#include "accel/canonical/lane_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// EdgeFunctions of sheared corners. Numbers: the tag of doubles, to decide, or of floats, to reject. A
/// product of two floats is exact in double, and so a fused multiply-subtract has the bits of separate steps;
/// in float it may have others, and no larger an error.
template <typename Numbers>
struct EdgeLanes {
  using Lanes = hn::Vec<Numbers>;

  Lanes a, b, c;

  HWY_ATTR HWY_INLINE EdgeLanes(const Lanes (&x)[3], const Lanes (&y)[3])
      : a(hn::MulSub(x[2], y[1], hn::Mul(y[2], x[1]))),
        b(hn::MulSub(x[0], y[2], hn::Mul(y[0], x[2]))),
        c(hn::MulSub(x[1], y[0], hn::Mul(y[1], x[0]))) {}

  /// Where one of them is below -error and another above it: the line passes beside the triangle.
  HWY_ATTR HWY_INLINE hn::Mask<Numbers> are_beside(Lanes error) const {
    return hn::And(hn::Lt(hn::Min(a, hn::Min(b, c)), hn::Neg(error)),
                   hn::Gt(hn::Max(a, hn::Max(b, c)), error));
  }
  HWY_ATTR HWY_INLINE hn::Mask<Numbers> are_beside() const {
    const Lanes zero = hn::Zero(Numbers());
    return hn::And(hn::Lt(hn::Min(a, hn::Min(b, c)), zero), hn::Gt(hn::Max(a, hn::Max(b, c)), zero));
  }
  HWY_ATTR HWY_INLINE Lanes determinant() const { return hn::Add(hn::Add(a, b), c); }
  /// Interpolates between the corners' numbers, times the determinant.
  HWY_ATTR HWY_INLINE Lanes weighted(Lanes at_a, Lanes at_b, Lanes at_c) const {
    return hn::Add(hn::Add(hn::Mul(a, at_a), hn::Mul(b, at_b)), hn::Mul(c, at_c));
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
