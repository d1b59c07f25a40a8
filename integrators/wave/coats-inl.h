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
  /// The surfaces from number k on.
  HWY_ATTR HWY_INLINE CoatedDiffuseLanes(const CoatedDiffuseSurfaces& at, std::size_t k)
      : rows_(at.rows.front().data()),
        row_(indices(at.row, k, at.size)),
        wo_(load(at.wo, k)),
        facets_{load(at.alpha_x, k), load(at.alpha_y, k)},
        is_smooth_(hn::Eq(facets_.x, hn::Zero(FloatTag()))),
        ior_(load(at.ior, k)),
        base_(load(at.base, k)),
        reflectance_(reflectance(wo_.z)) {
    const Lanes one = splat(1);
    const Lanes through = hn::Mul(hn::Sub(one, reflectance_), hn::Sub(one, load(at.average, k)));
    const Lanes most = hn::Max(base_.x, hn::Max(base_.y, base_.z));
    const Lanes all = hn::Add(reflectance_, hn::Mul(through, most));
    probability_ = select(is_positive(all), hn::Div(reflectance_, all), one);
  }

  HWY_ATTR HWY_INLINE BsdfLanes evaluate(const Lanes3& wi) const {
    const Lanes one = splat(1);
    FacetReflectionLanes coat = facets_.reflection(wo_, wi);
    coat.value = hn::IfThenZeroElse(is_smooth_, hn::Mul(coat.value, fresnel_dielectric(coat.cosine, ior_)));
    coat.pdf = hn::IfThenZeroElse(is_smooth_, coat.pdf);
    const Lanes through = hn::Mul(hn::Sub(one, reflectance_), hn::Sub(one, reflectance(wi.z)));
    const Lanes3 value = Lanes3{coat.value, coat.value, coat.value} + base_ * hn::Div(through, splat(pi));
    const Lanes cosine_pdf = hn::Div(positive(wi.z), splat(pi));
    const Lanes pdf =
        hn::Add(hn::Mul(probability_, coat.pdf), hn::Mul(hn::Sub(one, probability_), cosine_pdf));
    const LaneMask reflects = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {zero_unless(reflects, value), hn::IfThenElseZero(reflects, pdf)};
  }

  HWY_ATTR HWY_INLINE BsdfSampleLanes sample(Lanes lobe, Lanes u, Lanes v) const {
    const LaneMask reflects = hn::Lt(lobe, probability_), is_delta = hn::And(reflects, is_smooth_);
    const Lanes3 mirrored{hn::Neg(wo_.x), hn::Neg(wo_.y), wo_.z};
    const Lanes3 coat = select(is_smooth_, mirrored, facets_.sample_reflected(wo_, u, v));
    const Lanes3 wi = select(reflects, coat, square_to_cosine_hemisphere(u, v));
    const BsdfLanes found = evaluate(wi);
    const Lanes mirror = hn::Div(reflectance_, wi.z);
    const LaneMask leaves = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {wi, select(is_delta, Lanes3{mirror, mirror, mirror}, found.value),
            hn::IfThenElseZero(leaves, select(is_delta, probability_, found.pdf)), is_delta,
            hn::Not(reflects)};
  }

 private:
  /// Coat::reflectance.
  HWY_ATTR HWY_INLINE Lanes reflectance(Lanes cosine) const {
    const Lanes rough = at(rows_, row_, TablePlaceLanes(hn::Sqrt(cosine), tables::cosine_count));
    if (hn::AllFalse(FloatTag(), is_smooth_)) return rough;
    return select(is_smooth_, fresnel_dielectric(cosine, ior_), rough);
  }

  const float* rows_;
  IndexLanes row_;
  Lanes3 wo_;
  GgxLanes facets_;
  LaneMask is_smooth_;
  Lanes ior_;
  Lanes3 base_;
  Lanes reflectance_;  ///< Of the coat, towards wo.
  Lanes probability_;  ///< Of sampling the coat's reflection.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
