// SPDX-License-Identifier: Apache-2.0
// Private: vectors of doubles, for half of the lanes at a time, where the scalar code is in double; compiled
// once for each instruction set.
#if defined(TWINRAY_WAVE_DOUBLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_DOUBLE_LANES_INL_H
#undef TWINRAY_WAVE_DOUBLE_LANES_INL_H
#else
#define TWINRAY_WAVE_DOUBLE_LANES_INL_H
#endif

#include "integrators/wave/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Doubles of the lower and of the upper half of the lanes.
struct DoubleHalves {
  DoubleLanes lower, upper;
};

struct HalfLanes3 {
  HalfLanes x, y, z;
};
HWY_ATTR HWY_INLINE HalfLanes3 lower_half(const Lanes3& a) {
  const HalfTag half;
  return {hn::LowerHalf(half, a.x), hn::LowerHalf(half, a.y), hn::LowerHalf(half, a.z)};
}
HWY_ATTR HWY_INLINE HalfLanes3 upper_half(const Lanes3& a) {
  const HalfTag half;
  return {hn::UpperHalf(half, a.x), hn::UpperHalf(half, a.y), hn::UpperHalf(half, a.z)};
}
HWY_ATTR HWY_INLINE Lanes3 combine(const HalfLanes3& upper, const HalfLanes3& lower) {
  const FloatTag tag;
  return {hn::Combine(tag, upper.x, lower.x), hn::Combine(tag, upper.y, lower.y),
          hn::Combine(tag, upper.z, lower.z)};
}

struct DoubleLanes3 {
  DoubleLanes x, y, z;
};
HWY_ATTR HWY_INLINE DoubleLanes3 promote(const HalfLanes3& a) {
  const DoubleTag tag;
  return {hn::PromoteTo(tag, a.x), hn::PromoteTo(tag, a.y), hn::PromoteTo(tag, a.z)};
}
HWY_ATTR HWY_INLINE HalfLanes3 demote(const DoubleLanes3& a) {
  const HalfTag half;
  return {hn::DemoteTo(half, a.x), hn::DemoteTo(half, a.y), hn::DemoteTo(half, a.z)};
}
HWY_ATTR HWY_INLINE DoubleLanes dot(const DoubleLanes3& a, const DoubleLanes3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_ATTR HWY_INLINE DoubleLanes3 operator+(const DoubleLanes3& a, const DoubleLanes3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_ATTR HWY_INLINE DoubleLanes3 operator-(const DoubleLanes3& a, const DoubleLanes3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_ATTR HWY_INLINE DoubleLanes3 operator*(const DoubleLanes3& a, DoubleLanes s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_ATTR HWY_INLINE DoubleLanes3 operator/(const DoubleLanes3& a, DoubleLanes s) {
  return {hn::Div(a.x, s), hn::Div(a.y, s), hn::Div(a.z, s)};
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
