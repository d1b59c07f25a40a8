// SPDX-License-Identifier: Apache-2.0
// Private: PrincipledLobe in lanes, where it is bare(), compiled once for each instruction set.
#if defined(TWINRAY_WAVE_PRINCIPLED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_PRINCIPLED_INL_H
#undef TWINRAY_WAVE_PRINCIPLED_INL_H
#else
#define TWINRAY_WAVE_PRINCIPLED_INL_H
#endif

#include "integrators/wave/facets-inl.h"
#include "integrators/wave/lobes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// RoughDiffuseLobe, white.
struct RoughDiffuseLanes {
  Lanes roughness, scale, average, several;

  HWY_ATTR HWY_INLINE Lanes single_albedo(Lanes cosine) const {
    const Lanes x = hn::Sub(splat(1), cosine);
    const Lanes cubic =
        add_product(splat(0.491881867f), x, add_product(splat(-0.332181442f), x, splat(0.0714429953f)));
    const Lanes rim = hn::Mul(x, add_product(splat(0.0571085289f), x, cubic));
    return hn::Mul(scale, add_product(splat(1), roughness, rim));
  }
  HWY_ATTR HWY_INLINE Lanes evaluate(const Lanes3& wo, const Lanes3& wi) const {
    const Lanes one = splat(1), least = splat(1e-7f);
    const Lanes s = hn::Add(hn::Mul(wo.x, wi.x), hn::Mul(wo.y, wi.y));
    const Lanes tilt = select(is_positive(s), hn::Div(s, hn::Max(wo.z, wi.z)), s);
    const Lanes once = hn::Mul(scale, add_product(one, roughness, tilt));
    const auto missing = [&](Lanes albedo) HWY_ATTR { return hn::Max(least, hn::Sub(one, albedo)); };
    const Lanes both = hn::Mul(missing(single_albedo(wo.z)), missing(single_albedo(wi.z)));
    return hn::Mul(add_product(once, several, hn::Div(both, missing(average))), splat(1 / pi));
  }
};

/// TintedFresnel.
struct TintedFresnelLanes {
  Lanes3 normal, dip;

  HWY_ATTR HWY_INLINE Lanes3 operator()(Lanes cosine) const {
    const Lanes x = hn::Sub(splat(1), cosine);
    const Lanes x5 = hn::Mul(hn::Mul(hn::Mul(hn::Mul(x, x), x), x), x);
    const Lanes3 curve = normal + (splat(1, 1, 1) - normal) * x5 - dip * hn::Mul(hn::Mul(cosine, x5), x);
    return {not_above_1(positive(curve.x)), not_above_1(positive(curve.y)), not_above_1(positive(curve.z))};
  }
};

class PrincipledLanes {
 public:
  static constexpr Seeking seeking = Seeking::all;

  /// The surfaces from number k on.
  HWY_ATTR HWY_INLINE PrincipledLanes(const PrincipledSurfaces& at, std::size_t k)
      : wo_(load(at.wo, k)),
        metal_(load(at.metal, k)),
        opaque_(load(at.opaque, k)),
        fresnel_{load(at.metal_normal, k), load(at.metal_dip, k)},
        gloss_(at.gloss, k, at.size),
        multiple_(gloss_.facets, at.multiple, k),
        specular_color_(load(at.specular_color, k)),
        diffuse_(load(at.diffuse, k)),
        rough_{load(at.roughness, k), load(at.scale, k), load(at.average, k), load(at.several, k)},
        loss_(multiple_.loss(wo_)) {
    const Lanes one = splat(1), zero = splat(0), reflected = gloss_.reflectance(wo_.z);
    through_ = hn::Sub(one, reflected);
    const LaneMask is_opaque = is_positive(opaque_), is_metal = is_positive(metal_);
    const Lanes gloss = hn::Mul(hn::Mul(opaque_, largest(specular_color_)), reflected);
    const Lanes base = hn::Mul(hn::Mul(opaque_, largest(diffuse_)), through_);
    const Lanes once = hn::Mul(hn::Mul(metal_, largest(fresnel_(wo_.z))), hn::Sub(one, loss_));
    const Lanes more = hn::Mul(hn::Mul(metal_, largest(multiple_.factor)), loss_);
    const Lanes facets = hn::Add(hn::IfThenElseZero(is_opaque, gloss), hn::IfThenElseZero(is_metal, once));
    const Lanes matte = hn::Add(hn::IfThenElseZero(is_opaque, base), hn::IfThenElseZero(is_metal, more));
    const Lanes sum = hn::Add(facets, matte);
    const LaneMask reflects = is_positive(sum);
    facets_probability_ = select(reflects, hn::Div(facets, sum), zero);
    matte_probability_ = select(reflects, hn::Div(matte, sum), one);
  }

  HWY_ATTR HWY_INLINE BsdfLanes evaluate(const Lanes3& wi) const {
    const FacetReflectionLanes facets = gloss_.facets.reflection(wo_, wi);
    const Lanes3 metal = fresnel_(facets.cosine) * facets.value +
                         multiple_.factor * multiple_.evaluate(loss_, multiple_.loss(wi));
    const Lanes3 gloss =
        specular_color_ * hn::Mul(fresnel_dielectric(facets.cosine, gloss_.ior), facets.value);
    const Lanes through = hn::Mul(through_, hn::Sub(splat(1), gloss_.reflectance(wi.z)));
    const Lanes3 matte = diffuse_ * rough_.evaluate(wo_, wi) * through;
    const Lanes3 value = zero_unless(is_positive(metal_), metal * metal_) +
                         zero_unless(is_positive(opaque_), (gloss + matte) * opaque_);
    const Lanes pdf = hn::Add(hn::Mul(facets_probability_, facets.pdf),
                              hn::Mul(matte_probability_, cosine_hemisphere_pdf(wi.z)));
    const LaneMask reflects = hn::And(is_positive(wo_.z), is_positive(wi.z));
    return {zero_unless(reflects, value), hn::IfThenElseZero(reflects, pdf)};
  }

  HWY_ATTR HWY_INLINE BsdfSampleLanes sample(Lanes lobe, Lanes u, Lanes v) const {
    const LaneMask is_matte = hn::Lt(lobe, matte_probability_);
    const Lanes3 wi =
        select(is_matte, square_to_cosine_hemisphere(u, v), gloss_.facets.sample_reflected(wo_, u, v));
    const BsdfLanes found = evaluate(wi);
    const LaneMask none = hn::Lt(splat(1), splat(0));
    return {wi, found.value, found.pdf, none, is_matte};
  }

 private:
  Lanes3 wo_;
  Lanes metal_, opaque_;
  TintedFresnelLanes fresnel_;
  CoatLanes gloss_;
  MultipleLanes multiple_;
  Lanes3 specular_color_, diffuse_;
  RoughDiffuseLanes rough_;
  Lanes loss_;                                    ///< Of light that meets several facets, towards wo.
  Lanes through_;                                 ///< What the gloss lets through, towards wo.
  Lanes facets_probability_, matte_probability_;  ///< PrincipledLobe::Choice.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
