// SPDX-License-Identifier: Apache-2.0
// Private: where light is gathered, in lanes, compiled once for each instruction set: core/light_patch.h's
// Receiver.
#if defined(TWINRAY_WAVE_RECEIVERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_RECEIVERS_INL_H
#undef TWINRAY_WAVE_RECEIVERS_INL_H
#else
#define TWINRAY_WAVE_RECEIVERS_INL_H
#endif

#include "integrators/wave/lanes-inl.h"
#include "integrators/wave/wave.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

struct ReceiverLanes {
  Lanes3 position, normal;
  LaneMask lets_light_through, is_in_medium;
  bool are_surfaces;  ///< All of them.
};
HWY_ATTR HWY_INLINE ReceiverLanes load_receivers(const Surfaces& surfaces, std::size_t i) {
  const Lanes3 normal = load(surfaces.shading, i);
  const LaneMask is_in_medium = hn::Eq(dot(normal, normal), hn::Zero(FloatTag()));
  return {load(surfaces.point.position, i), normal,
          hn::RebindMask(FloatTag(), hn::Ne(load(surfaces.lets_through, i), hn::Zero(WordTag()))),
          is_in_medium, hn::AllFalse(FloatTag(), is_in_medium)};
}

/// Receiver::facing.
HWY_ATTR HWY_INLINE Lanes facing(const ReceiverLanes& receivers, const Lanes3& towards) {
  const Lanes cosine = dot(receivers.normal, towards);
  if (receivers.are_surfaces) return cosine;
  return select(receivers.is_in_medium, hn::Sqrt(dot(towards, towards)), cosine);
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
