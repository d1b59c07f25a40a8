// SPDX-License-Identifier: Apache-2.0
// Private: CoatedDiffuseLobe in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_COATS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_COATS_INL_H
#undef TWINRAY_WAVE_COATS_INL_H
#else
#define TWINRAY_WAVE_COATS_INL_H
#endif

#include "integrators/wave/facets-inl.h"
#include "integrators/wave/lobes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

class CoatedDiffuseLanes {
 public:
  static constexpr Seeking seeking = Seeking::all;

  /// The surfaces from number k on.
  HWY_ATTR HWY_INLINE CoatedDiffuseLanes(const CoatedDiffuseSurfaces& at, std::size_t k)
      : wo_(load(at.wo, k)),
        coat_(at.coat, k, at.size),
        base_(load(at.base, k)),
        reflectance_(coat_.reflectance(wo_.z)) {
    const Lanes one = splat(1);
    const Lanes through = hn::Mul(hn::Sub(one, reflectance_), hn::Sub(one, load(at.average, k)));
    const Lanes all = hn::Add(reflectance_, hn::Mul(through, largest(base_)));
    probability_ = select(is_positive(all), hn::Div(reflectance_, all), one);
  }

  HWY_ATTR HWY_INLINE BsdfLanes evaluate(const Lanes3& wi) const {
    const Lanes one = splat(1);
    const FacetReflectionLanes facets = coat_.facets.reflection(wo_, wi);
    const Lanes reflected = hn::IfThenZeroElse(
        coat_.is_smooth, hn::Mul(facets.value, fresnel_dielectric(facets.cosine, coat_.ior)));
    const Lanes facet_pdf = hn::IfThenZeroElse(coat_.is_smooth, facets.pdf);
    const Lanes through = hn::Mul(hn::Sub(one, reflectance_), hn::Sub(one, coat_.reflectance(wi.z)));
    const Lanes3 value = Lanes3{reflected, reflected, reflected} + base_ * hn::Div(through, splat(pi));
    const Lanes pdf = hn::Add(hn::Mul(probability_, facet_pdf),
                              hn::Mul(hn::Sub(one, probability_), cosine_hemisphere_pdf(wi.z)));
    const LaneMask reflects = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {zero_unless(reflects, value), hn::IfThenElseZero(reflects, pdf)};
  }

  HWY_ATTR HWY_INLINE BsdfSampleLanes sample(Lanes lobe, Lanes u, Lanes v) const {
    const LaneMask reflects = hn::Lt(lobe, probability_), is_delta = hn::And(reflects, coat_.is_smooth);
    const Lanes3 mirrored{hn::Neg(wo_.x), hn::Neg(wo_.y), wo_.z};
    const Lanes3 coat = select(coat_.is_smooth, mirrored, coat_.facets.sample_reflected(wo_, u, v));
    const Lanes3 wi = select(reflects, coat, square_to_cosine_hemisphere(u, v));
    const BsdfLanes found = evaluate(wi);
    const Lanes mirror = hn::Div(reflectance_, wi.z);
    const LaneMask leaves = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {wi, select(is_delta, Lanes3{mirror, mirror, mirror}, found.value),
            hn::IfThenElseZero(leaves, select(is_delta, probability_, found.pdf)), is_delta,
            hn::Not(reflects)};
  }

 private:
  Lanes3 wo_;
  CoatLanes coat_;
  Lanes3 base_;
  Lanes reflectance_;  ///< Of the coat, towards wo.
  Lanes probability_;  ///< Of sampling the coat's reflection.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
