// SPDX-License-Identifier: Apache-2.0
// Private: vectors of lanes over columns, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LANES_INL_H
#undef TWINRAY_WAVE_LANES_INL_H
#else
#define TWINRAY_WAVE_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/rgb.h"
#include "integrators/wave/columns.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, column_padding>;
using WordTag = hn::RebindToUnsigned<FloatTag>;
using HalfTag = hn::Half<FloatTag>;
using HalfWordTag = hn::Half<WordTag>;
using DoubleTag = hn::Rebind<double, HalfTag>;
using LongTag = hn::Rebind<std::uint64_t, HalfWordTag>;
using Lanes = hn::Vec<FloatTag>;
using WordLanes = hn::Vec<WordTag>;
using LongLanes = hn::Vec<LongTag>;
using HalfLanes = hn::Vec<HalfTag>;
using DoubleLanes = hn::Vec<DoubleTag>;
using LaneMask = hn::Mask<FloatTag>;
inline constexpr std::size_t lane_count = hn::MaxLanes(FloatTag());

HWY_ATTR HWY_INLINE Lanes splat(float a) { return hn::Set(FloatTag(), a); }
HWY_ATTR HWY_INLINE Lanes load(const Floats& column, std::size_t i) {
  return hn::Load(FloatTag(), column.values + i);
}
HWY_ATTR HWY_INLINE void store(Lanes a, Floats& column, std::size_t i) {
  hn::Store(a, FloatTag(), column.values + i);
}
HWY_ATTR HWY_INLINE WordLanes load(const Words& column, std::size_t i) {
  return hn::Load(WordTag(), column.values + i);
}
HWY_ATTR HWY_INLINE void store(WordLanes a, Words& column, std::size_t i) {
  hn::Store(a, WordTag(), column.values + i);
}
HWY_ATTR HWY_INLINE Lanes select(LaneMask mask, Lanes yes, Lanes no) { return hn::IfThenElse(mask, yes, no); }

/// Three lanes: vectors or colours. The operations are those of core/vec.h, in their order.
struct Lanes3 {
  Lanes x, y, z;
};
HWY_ATTR HWY_INLINE Lanes3 load(const Columns3& columns, std::size_t i) {
  return {load(columns.x, i), load(columns.y, i), load(columns.z, i)};
}
HWY_ATTR HWY_INLINE void store(const Lanes3& a, Columns3& columns, std::size_t i) {
  store(a.x, columns.x, i);
  store(a.y, columns.y, i);
  store(a.z, columns.z, i);
}
HWY_ATTR HWY_INLINE Lanes3 splat(float a, float b, float c) { return {splat(a), splat(b), splat(c)}; }
HWY_ATTR HWY_INLINE Lanes3 splat(const Vec3& v) { return splat(v.x, v.y, v.z); }
HWY_ATTR HWY_INLINE Lanes3 splat(const Rgb& c) { return splat(c.r, c.g, c.b); }
HWY_ATTR HWY_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_ATTR HWY_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_ATTR HWY_INLINE Lanes3 operator*(const Lanes3& a, const Lanes3& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_ATTR HWY_INLINE Lanes3 operator*(const Lanes3& a, Lanes s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_ATTR HWY_INLINE Lanes3 operator/(const Lanes3& a, Lanes s) {
  return {hn::Div(a.x, s), hn::Div(a.y, s), hn::Div(a.z, s)};
}
HWY_ATTR HWY_INLINE Lanes3 operator-(const Lanes3& a) { return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)}; }
HWY_ATTR HWY_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_ATTR HWY_INLINE Lanes3 select(LaneMask mask, const Lanes3& yes, const Lanes3& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_ATTR HWY_INLINE Lanes3 zero_unless(LaneMask mask, const Lanes3& a) {
  return {hn::IfThenElseZero(mask, a.x), hn::IfThenElseZero(mask, a.y), hn::IfThenElseZero(mask, a.z)};
}
HWY_ATTR HWY_INLINE LaneMask is_positive(Lanes a) { return hn::Gt(a, hn::Zero(FloatTag())); }
HWY_ATTR HWY_INLINE LaneMask is_positive_and_finite(Lanes a) {
  return hn::And(is_positive(a), hn::Lt(a, splat(std::numeric_limits<float>::infinity())));
}
/// std::max(0, a): 0 where a is NaN.
HWY_ATTR HWY_INLINE Lanes positive(Lanes a) { return hn::IfThenElseZero(is_positive(a), a); }
/// Not a number is not black, as with is_black(): Ne() says so on some processors alone.
HWY_ATTR HWY_INLINE LaneMask is_not_black(const Lanes3& c) {
  const Lanes zero = hn::Zero(FloatTag());
  return hn::Not(hn::And(hn::Eq(c.x, zero), hn::And(hn::Eq(c.y, zero), hn::Eq(c.z, zero))));
}
/// Bit i: lane i of the mask.
HWY_ATTR HWY_INLINE std::uint32_t bits_of(LaneMask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(FloatTag(), mask, bits);
  return bits[0] | std::uint32_t(bits[1]) << 8;
}
/// The lanes of paths below `size`, from path i on.
HWY_ATTR HWY_INLINE LaneMask within(std::size_t i, std::size_t size) {
  return hn::FirstN(FloatTag(), size - i);
}

/// 64-bit words of the lower and of the upper half of the lanes, from columns that have them in halves.
struct LongHalves {
  LongLanes lower, upper;
};
HWY_ATTR HWY_INLINE LongLanes join(hn::Vec<HalfWordTag> low, hn::Vec<HalfWordTag> high) {
  return hn::Or(hn::PromoteTo(LongTag(), low), hn::ShiftLeft<32>(hn::PromoteTo(LongTag(), high)));
}
HWY_ATTR HWY_INLINE LongHalves join(WordLanes low, WordLanes high) {
  return {join(hn::LowerHalf(HalfWordTag(), low), hn::LowerHalf(HalfWordTag(), high)),
          join(hn::UpperHalf(HalfWordTag(), low), hn::UpperHalf(HalfWordTag(), high))};
}
HWY_ATTR HWY_INLINE WordLanes low_words(const LongHalves& a) {
  return hn::ConcatEven(WordTag(), hn::BitCast(WordTag(), a.upper), hn::BitCast(WordTag(), a.lower));
}
HWY_ATTR HWY_INLINE WordLanes high_words(const LongHalves& a) {
  return hn::ConcatOdd(WordTag(), hn::BitCast(WordTag(), a.upper), hn::BitCast(WordTag(), a.lower));
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
