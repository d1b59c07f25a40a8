// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/stand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/shading_map.h"
#include "core/textured_material.h"
#include "io/exchange/writer.h"
#include "io/one_base.h"

namespace twinray {
namespace {

constexpr float at_least_half = 0.5f;

/// What alpha along the tangent and across is, in squares of OpenPBR's roughness.
Roughness facet_factors(float anisotropy) {
  const float ratio = 1 - anisotropy, along = std::sqrt(2 / (1 + ratio * ratio));
  return {along, ratio * along};
}

/// Alpha along the tangent and across, of OpenPBR's roughness and anisotropy.
Roughness alpha_of(float roughness, float anisotropy) {
  const float squared = roughness * roughness;
  const auto [along, across] = facet_factors(anisotropy);
  return {std::min(squared * along, 1.0f), std::min(squared * across, 1.0f)};
}

class StandIn {
 public:
  StandIn(const Material& material, Losses& losses)
      : material_(with_one_base(material, losses)),
        has_subsurface_(has_subsurface(material)),
        losses_(losses) {}

  PbrtStandIn make() {
    made_.material = material_;
    std::visit([&](const auto& model) { made_.material.model = of(model); }, material_.model);
    Subsurface& below = made_.material.subsurface;
    if (!std::holds_alternative<CoatedDiffuse>(made_.material.model)) below = {};
    if (has_subsurface_ && is_black(below.radius)) lose("light below the surface");
    if (has_tangent(made_.material)) lose("the direction of the facets");
    return std::move(made_);
  }

 private:
  /// Names the loss, and gives what stands there.
  SurfaceModel instead(const char* one, const char* many, const SurfaceModel& model) {
    const std::string type = type_of(material_.model);
    losses_.add(fmt::format("a material of the type {} is written as a {}", type, one),
                fmt::format("{{}} materials of the type {} are written as {}", type, many));
    return model;
  }
  void lose(const char* what) {
    const std::string type = type_of(material_.model);
    losses_.add(fmt::format("{} of a material of the type {} is left out", what, type),
                fmt::format("{} of {{}} materials of the type {} is left out", what, type));
  }

  SurfaceModel of(const Lambert& model) { return model; }
  SurfaceModel of(const Interface& model) { return model; }
  SurfaceModel of(const Mix& model) { return model; }
  SurfaceModel of(const DiffuseTransmission& model) { return model; }
  SurfaceModel of(const CoatedDiffuse& model) { return model; }
  SurfaceModel of(const RoughDiffuse& model) {
    return instead("diffuse surface", "diffuse surfaces", Lambert{model.reflectance});
  }
  SurfaceModel of(const Measured& model) { return model; }
  SurfaceModel of(const Hair& model) {
    return instead("diffuse surface", "diffuse surfaces", Lambert{model.reflectance});
  }
  SurfaceModel of(const Mirror& model) {
    use_as_metal();
    return instead("smooth conductor", "smooth conductors", Conductor{white, metal_k(model.reflectance)});
  }
  SurfaceModel of(const Microfacet& model) {
    return instead("conductor of GGX facets", "conductors of GGX facets",
                   Conductor{model.eta, model.k, {model.alpha, model.alpha}});
  }
  SurfaceModel of(const Refraction& model) {
    return instead("dielectric, which also reflects", "dielectrics, which also reflect",
                   Dielectric{model.ior});
  }
  SurfaceModel of(const Glass& model) {
    if (!(model.transmittance == white && model.reflectance == white)) lose("the color");
    return Dielectric{model.ior};
  }
  SurfaceModel of(const Dielectric& model) {
    if (!(model.transmittance == white && model.reflectance == white)) lose("the color");
    Dielectric clear = model;
    clear.reflectance = clear.transmittance = white;
    return clear;
  }
  SurfaceModel of(const Conductor& model) {
    if (model.reflectance != white) lose("the factor");
    Conductor plain = model;
    plain.reflectance = white;
    return plain;
  }
  SurfaceModel of(const CoatedConductor& model) {
    if (model.reflectance != white) lose("the factor");
    CoatedConductor plain = model;
    plain.reflectance = white;
    return plain;
  }

  SurfaceModel of(const Principled& model) {
    made_.squares_roughness = true;
    made_.facet_factors = facet_factors(model.specular_roughness_anisotropy);
    made_.base_weight = model.base_weight;
    const Roughness alpha = alpha_of(model.specular_roughness, model.specular_roughness_anisotropy);
    const Rgb base = model.base_color * model.base_weight;
    if (model.base_metalness >= at_least_half) return metal(model, base, alpha);
    if (model.transmission_weight >= at_least_half) return clear(model, alpha);
    if (model.coat_weight >= at_least_half) {
      use_coat();
      const Roughness coat = alpha_of(model.coat_roughness, 0);
      return instead("coated diffuse surface", "coated diffuse surfaces",
                     CoatedDiffuse{base, coat, model.coat_ior});
    }
    if (model.specular_weight == 0) return instead("diffuse surface", "diffuse surfaces", Lambert{base});
    return instead("coated diffuse surface", "coated diffuse surfaces",
                   CoatedDiffuse{base, alpha, model.specular_ior});
  }
  SurfaceModel metal(const Principled& model, const Rgb& color, const Roughness& alpha) {
    use_as_metal();
    if (model.coat_weight < at_least_half)
      return instead("conductor", "conductors", Conductor{white, metal_k(color), alpha});
    CoatedConductor coated{white, metal_k(color), alpha};
    coated.coat_roughness = alpha_of(model.coat_roughness, 0);
    coated.coat_ior = model.coat_ior;
    return instead("coated conductor", "coated conductors", coated);
  }
  SurfaceModel clear(const Principled& model, const Roughness& alpha) {
    Dielectric dielectric{model.specular_ior, alpha};
    dielectric.is_thin = model.geometry_thin_walled;
    const bool is_tinted = model.transmission_depth == 0 && model.transmission_color != white;
    if (is_tinted && !texture_use(material_, MaterialInput::transmission_color)) lose("the color");
    if (dielectric.is_thin) return instead("thin dielectric", "thin dielectrics", dielectric);
    return instead("dielectric", "dielectrics", dielectric);
  }

  /// Textures of the reflectance are those of a metal's.
  void use_as_metal() {
    for (TextureUse& use : made_.material.textures)
      if (use.input == MaterialInput::reflectance)
        use.input = MaterialInput::k, use.meaning = InputMeaning::metal_reflectance;
  }

  /// Textures of the coat's roughness are those of the only one that there is.
  void use_coat() {
    made_.facet_factors = {1, 1};
    std::vector<TextureUse>& uses = made_.material.textures;
    std::erase_if(uses, [](const TextureUse& use) { return use.input == MaterialInput::roughness; });
    for (TextureUse& use : uses)
      if (use.input == MaterialInput::coat_roughness) use.input = MaterialInput::roughness;
  }

  const Material material_;
  const bool has_subsurface_;
  Losses& losses_;
  PbrtStandIn made_;
};

}  // namespace

PbrtStandIn pbrt_stand_in(const Material& material, Losses& losses) {
  return StandIn(material, losses).make();
}

}  // namespace twinray
