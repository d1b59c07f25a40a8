// SPDX-License-Identifier: Apache-2.0
// Private: the vectors in which the primitives of a block are tested, and the least hit of several lanes;
// compiled once for each instruction set.
#if defined(TWINRAY_ACCEL_BLOCK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_BLOCK_LANES_INL_H
#undef TWINRAY_ACCEL_BLOCK_LANES_INL_H
#else
#define TWINRAY_ACCEL_BLOCK_LANES_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/lane_bits-inl.h"
#include "accel/canonical/nearest.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Lanes are doubles, as many as a vector holds but no more than a block does, or the floats of as many.
struct BlockLanes {
  using Doubles = hn::CappedTag<double, PrimitiveBlock::width>;
  using Floats = hn::Rebind<float, Doubles>;
  using DoubleLanes = hn::Vec<Doubles>;
  using FloatLanes = hn::Vec<Floats>;
  static constexpr std::size_t lane_count = hn::MaxLanes(Doubles());

  /// Of a block's lanes, given as bits, those from `first` on that a vector holds.
  static HWY_ATTR HWY_INLINE std::uint32_t some_of(std::uint32_t lanes, std::size_t first) {
    return (lanes >> first) & ((1u << lane_count) - 1);
  }
  static HWY_ATTR HWY_INLINE std::uint32_t within(FloatLanes t, float t_min, float t_max) {
    return bits_of(Floats(),
                   hn::And(hn::Ge(t, hn::Set(Floats(), t_min)), hn::Le(t, hn::Set(Floats(), t_max))));
  }
  /// Keeps the least of the hits in some lanes of a block, counted from `first` on: `hits` are bits, at least
  /// one; no t lies behind best.t; `terms` are what Nearest makes u and v of.
  static HWY_ATTR HWY_INLINE void keep(const PrimitiveBlock& block, std::size_t first, std::uint32_t hits,
                                       FloatLanes t, const DoubleLanes (&terms)[3], Nearest& best) {
    alignas(16) float depths[PrimitiveBlock::width];
    hn::Store(t, Floats(), depths + first);
    int lane = std::countr_zero(hits << first);
    if (hits & (hits - 1)) lane = least_lane(block, hits << first, depths);
    if (depths[lane] == best.t && best.id() < block.ids[lane]) return;
    best.t = depths[lane];
    best.lane = lane;
    best.block = &block;
    for (int i = 0; i < 3; ++i) hn::Store(terms[i], Doubles(), best.uv_terms[i] + first);
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
