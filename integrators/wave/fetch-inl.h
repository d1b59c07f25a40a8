// SPDX-License-Identifier: Apache-2.0
// Private: what lanes read of an array of structures, each lane of an element of its own; compiled once for
// each instruction set.
#if defined(TWINRAY_WAVE_FETCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_FETCH_INL_H
#undef TWINRAY_WAVE_FETCH_INL_H
#else
#define TWINRAY_WAVE_FETCH_INL_H
#endif

#include "integrators/wave/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Members of elements; each is named by that of the array's first element.
class Fetch {
 public:
  /// The elements' size in bytes is a multiple of 4, and the array has less than 2^31 such words.
  HWY_ATTR HWY_INLINE Fetch(WordLanes element, std::size_t size)
      : place_(hn::BitCast(Signed(),
                           hn::Mul(element, hn::Set(WordTag(), std::uint32_t(size / sizeof(float)))))) {}

  HWY_ATTR HWY_INLINE Lanes number(const float& of_first) const {
    return hn::GatherIndex(FloatTag(), &of_first, place_);
  }
  HWY_ATTR HWY_INLINE WordLanes word(const std::uint32_t& of_first) const {
    return hn::GatherIndex(WordTag(), &of_first, place_);
  }
  HWY_ATTR HWY_INLINE Lanes3 vector(const Vec3& of_first) const {
    return {number(of_first.x), number(of_first.y), number(of_first.z)};
  }

 private:
  using Signed = hn::RebindToSigned<FloatTag>;

  hn::Vec<Signed> place_;
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
