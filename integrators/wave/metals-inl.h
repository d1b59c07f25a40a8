// SPDX-License-Identifier: Apache-2.0
// Private: RoughConductorLobe in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_METALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_METALS_INL_H
#undef TWINRAY_WAVE_METALS_INL_H
#else
#define TWINRAY_WAVE_METALS_INL_H
#endif

#include "integrators/wave/facets-inl.h"
#include "integrators/wave/lobes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

class RoughConductorLanes {
 public:
  static constexpr Seeking seeking = Seeking::all;

  /// The surfaces from number k on.
  HWY_ATTR HWY_INLINE RoughConductorLanes(const RoughConductorSurfaces& at, std::size_t k)
      : wo_(load(at.wo, k)),
        facets_(ggx(at.facets, k)),
        eta_(load(at.eta, k)),
        k_(load(at.k, k)),
        reflectance_(load(at.reflectance, k)),
        multiple_(facets_, at.multiple, k),
        loss_(multiple_.loss(wo_)) {
    const Lanes once = hn::Mul(hn::Sub(splat(1), loss_), load(at.most_once, k));
    const Lanes more = hn::Mul(loss_, load(at.most_multiple, k));
    multiple_probability_ = hn::IfThenElseZero(is_positive(more), hn::Div(more, hn::Add(once, more)));
  }

  HWY_ATTR HWY_INLINE BsdfLanes evaluate(const Lanes3& wi) const {
    const FacetReflectionLanes facets = facets_.reflection(wo_, wi);
    const Lanes3 fresnel{fresnel_conductor(facets.cosine, eta_.x, k_.x),
                         fresnel_conductor(facets.cosine, eta_.y, k_.y),
                         fresnel_conductor(facets.cosine, eta_.z, k_.z)};
    const Lanes3 once = reflectance_ * fresnel * facets.value;
    const Lanes3 more = reflectance_ * multiple_.factor * multiple_.evaluate(loss_, multiple_.loss(wi));
    const Lanes pdf = hn::Add(hn::Mul(hn::Sub(splat(1), multiple_probability_), facets.pdf),
                              hn::Mul(multiple_probability_, cosine_hemisphere_pdf(wi.z)));
    const LaneMask reflects = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {zero_unless(reflects, once + more), hn::IfThenElseZero(reflects, pdf)};
  }

  HWY_ATTR HWY_INLINE BsdfSampleLanes sample(Lanes lobe, Lanes u, Lanes v) const {
    const LaneMask is_multiple = hn::Lt(lobe, multiple_probability_);
    const Lanes3 wi =
        select(is_multiple, square_to_cosine_hemisphere(u, v), facets_.sample_reflected(wo_, u, v));
    const BsdfLanes found = evaluate(wi);
    const LaneMask none = hn::Lt(splat(1), splat(0));
    return {wi, found.value, found.pdf, none, none};
  }

 private:
  Lanes3 wo_;
  GgxLanes facets_;
  Lanes3 eta_, k_, reflectance_;
  MultipleLanes multiple_;
  Lanes loss_;                  ///< Its loss towards wo,
  Lanes multiple_probability_;  ///< and the probability of sampling it.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
