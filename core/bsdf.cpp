// SPDX-License-Identifier: Apache-2.0
#include "core/bsdf.h"

#include <type_traits>

namespace twinray {
namespace {

bool is_smooth(const Roughness& r) { return std::max(r.x, r.y) < least_alpha; }

/// Of a surface that is rough along one axis at least.
Ggx facets(const Roughness& r) { return {std::max(r.x, least_alpha), std::max(r.y, least_alpha)}; }

Coat coat(float ior, const Roughness& roughness) {
  return is_smooth(roughness) ? Coat(ior) : Coat(ior, facets(roughness));
}

/// Which lobe a model has on the viewer's side.
struct LobesOf {
  Side side;

  /// Of what is beyond the surface, to what is before it.
  float ratio(float ior) const { return side == Side::outside ? ior : 1 / ior; }

  Bsdf::Lobes operator()(const Lambert& m) const { return LambertLobe{m.reflectance}; }
  Bsdf::Lobes operator()(const Mirror& m) const { return MirrorLobe(m.reflectance); }
  Bsdf::Lobes operator()(const Refraction& m) const { return RefractionLobe(ratio(m.ior), m.transmittance); }
  Bsdf::Lobes operator()(const Glass& m) const {
    return SmoothDielectricLobe(ratio(m.ior), m.reflectance, m.transmittance);
  }
  Bsdf::Lobes operator()(const Dielectric& m) const {
    if (m.is_thin) return ThinDielectricLobe(m.ior, m.reflectance, m.transmittance);
    if (is_smooth(m.roughness) || m.ior == 1)
      return SmoothDielectricLobe(ratio(m.ior), m.reflectance, m.transmittance);
    return RoughDielectricLobe(facets(m.roughness), ratio(m.ior), m.reflectance, m.transmittance);
  }
  Bsdf::Lobes operator()(const Conductor& m) const {
    if (is_smooth(m.roughness)) return SmoothConductorLobe(m.eta, m.k, m.reflectance);
    return RoughConductorLobe(facets(m.roughness), m.eta, m.k, m.reflectance);
  }
  Bsdf::Lobes operator()(const Microfacet& m) const { return Cs184MicrofacetLobe(m.alpha, m.eta, m.k); }
  Bsdf::Lobes operator()(const DiffuseTransmission& m) const {
    const float most = std::max(max_component(m.reflectance + m.transmittance), 1.0f);
    return DiffuseTransmissionLobe{m.reflectance / most, m.transmittance / most};
  }
  Bsdf::Lobes operator()(const RoughDiffuse& m) const { return RoughDiffuseLobe(m.reflectance, m.roughness); }
  Bsdf::Lobes operator()(const CoatedDiffuse& m) const {
    return CoatedDiffuseLobe(coat(m.ior, m.roughness), m.reflectance);
  }
  Bsdf::Lobes operator()(const CoatedConductor& m) const {
    const float ior = std::max(1.0f, m.coat_ior);
    const Rgb eta = m.eta / ior, k = m.k / ior;
    if (is_smooth(m.roughness) && is_smooth(m.coat_roughness))
      return SmoothCoatedConductorLobe(ior, eta, k, m.reflectance);
    return CoatedConductorLobe(coat(ior, m.coat_roughness), facets(m.roughness), eta, k, m.reflectance);
  }
  Bsdf::Lobes operator()(const Principled& m) const { return PrincipledLobe(m, side == Side::inside); }
  Bsdf::Lobes operator()(const Hair& m) const { return HairLobe(m); }
  Bsdf::Lobes operator()(const Measured& m) const { return MeasuredLobe(*m.brdf, side == Side::inside); }
  Bsdf::Lobes operator()(const Interface&) const { return PassageLobe{}; }
  Bsdf::Lobes operator()(const Mix&) const { return LambertLobe{}; }
};

/// What f makes of the lobe; nothing of one that has not what f asks for.
template <typename Result, typename F>
Result of_lobe(const Bsdf::Lobes& lobes, const F& f) {
  return std::visit(
      [&](const auto& lobe) -> Result {
        if constexpr (std::is_invocable_v<F, decltype(lobe)>) return f(lobe);
        return {};
      },
      lobes);
}

}  // namespace

Rgb Bsdf::diffuse(const Vec3& wo, const Vec3& wi) const {
  const auto of = [&](const auto& lobe) -> Rgb {
    using Lobe = std::decay_t<decltype(lobe)>;
    if constexpr (requires { lobe.diffuse(wo, wi); }) return lobe.diffuse(wo, wi);
    if constexpr (std::is_same_v<Lobe, LambertLobe> || std::is_same_v<Lobe, RoughDiffuseLobe> ||
                  std::is_same_v<Lobe, DiffuseTransmissionLobe>)
      return wi.z > 0 ? lobe.evaluate(wo, wi).value : Rgb{};
    return {};
  };
  return std::visit(of, lobes_);
}

BelowSurface Bsdf::below(const Vec3& wo) const {
  return of_lobe<BelowSurface>(lobes_,
                               [&](const auto& lobe) -> decltype(lobe.below(wo)) { return lobe.below(wo); });
}

Rgb Bsdf::of_below(const Vec3& wo, const Vec3& wi) const {
  return of_lobe<Rgb>(
      lobes_, [&](const auto& lobe) -> decltype(lobe.of_below(wo, wi)) { return lobe.of_below(wo, wi); });
}

Rgb Bsdf::from_below(const Vec3& wi) const {
  return of_lobe<Rgb>(lobes_,
                      [&](const auto& lobe) -> decltype(lobe.from_below(wi)) { return lobe.from_below(wi); });
}

bool Bsdf::lets_light_through() const {
  const auto of = [](const auto& lobe) {
    using Lobe = std::decay_t<decltype(lobe)>;
    if constexpr (requires { lobe.lets_light_through(); }) return lobe.lets_light_through();
    return std::is_same_v<Lobe, RoughDielectricLobe> || std::is_same_v<Lobe, DiffuseTransmissionLobe>;
  };
  return std::visit(of, lobes_);
}

Bsdf::Bsdf(const SurfaceModel& model, Side side) : lobes_(std::visit(LobesOf{side}, model)) {}

}  // namespace twinray
