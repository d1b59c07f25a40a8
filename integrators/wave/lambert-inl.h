// SPDX-License-Identifier: Apache-2.0
// Private: LambertLobe in lanes, where maps bend its normal, compiled once for each instruction set. Other
// Lambert surfaces are lit and scatter in place (light-inl.h, scatter-inl.h).
#if defined(TWINRAY_WAVE_LAMBERT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LAMBERT_INL_H
#undef TWINRAY_WAVE_LAMBERT_INL_H
#else
#define TWINRAY_WAVE_LAMBERT_INL_H
#endif

#include "integrators/wave/lobes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

class LambertLanes {
 public:
  static constexpr Seeking seeking = Seeking::zones;

  /// The surfaces from number k on.
  HWY_ATTR HWY_INLINE LambertLanes(const LambertSurfaces& at, std::size_t k)
      : wo_(load(at.wo, k)), reflectance_(load(at.reflectance, k)) {}

  HWY_ATTR HWY_INLINE BsdfLanes evaluate(const Lanes3& wi) const {
    const LaneMask reflects = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {zero_unless(reflects, reflectance_ * splat(1 / pi)),
            hn::IfThenElseZero(reflects, cosine_hemisphere_pdf(wi.z))};
  }

  HWY_ATTR HWY_INLINE BsdfSampleLanes sample(Lanes /*lobe*/, Lanes u, Lanes v) const {
    const Lanes3 wi = square_to_cosine_hemisphere(u, v);
    const BsdfLanes found = evaluate(wi);
    const LaneMask none = hn::Lt(splat(1), splat(0));
    return {wi, found.value, found.pdf, none, hn::Not(none)};
  }

 private:
  Lanes3 wo_, reflectance_;
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
