// SPDX-License-Identifier: Apache-2.0
// Private: masks of lanes as bits, compiled once for each instruction set.
#if defined(TWINRAY_ACCEL_LANE_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_LANE_BITS_INL_H
#undef TWINRAY_ACCEL_LANE_BITS_INL_H
#else
#define TWINRAY_ACCEL_LANE_BITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Bit i: lane i of a mask of at most eight lanes.
template <typename Tag>
HWY_ATTR HWY_INLINE std::uint32_t bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  return bits[0];
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
