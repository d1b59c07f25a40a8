// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/stand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/measured_brdf.h"
#include "core/textured_material.h"
#include "io/exchange/writer.h"
#include "io/one_base.h"

namespace twinray {
namespace {

/// What a smooth metal reflects of the light that falls straight on it.
Rgb reflected(const Rgb& eta, const Rgb& k) {
  const auto channel = [](float n, float a) {
    return ((n - 1) * (n - 1) + a * a) / ((n + 1) * (n + 1) + a * a);
  };
  return {channel(eta.r, k.r), channel(eta.g, k.g), channel(eta.b, k.b)};
}

/// A material without what io/gltf/layers.cpp mixes into the specular reflection where there is metal, which
/// the format spares by itself; and the inputs that had it.
struct PlainMaterial {
  Material material;
  std::vector<MaterialInput> spared;
};

class StandIn {
 public:
  StandIn(const PlainMaterial& plain, Losses& losses)
      : material_(plain.material), spared_(plain.spared), losses_(losses) {}

  GltfStandIn make() {
    made_.material = material_;
    model_.coat_ior = 1.5f;
    model_.coat_darkening = 0;
    std::visit([&](const auto& model) { take(model); }, material_.model);
    made_.material.model = model_;
    for (const TextureUse& use : material_.textures)
      if (use.meaning == InputMeaning::squared_roughness) made_.roughness_power = 0.25f;
    return std::move(made_);
  }

 private:
  void name(const char* one, const char* many) {
    const std::string type = type_of(material_.model);
    losses_.add(fmt::format("a material of the type {} is written as a {}", type, one),
                fmt::format("{{}} materials of the type {} are written as {}", type, many));
  }
  void lose(const char* what) {
    losses_.add(fmt::format("{} of a material is left out", what),
                fmt::format("{} of {{}} materials is left out", what));
  }

  bool has_texture(MaterialInput input) const { return texture_use(made_.material, input) != nullptr; }

  /// A diffuse surface, which reflects nothing by facets.
  void make_diffuse(const Rgb& reflectance) {
    model_.base_color = reflectance;
    model_.specular_weight = 0;
    model_.specular_roughness = 1;
  }
  void make_metal(const Rgb& color, const Roughness& alpha) {
    model_.base_metalness = 1;
    model_.base_color = color;
    set_alpha(alpha);
    made_.roughness_power = 0.5f;
    for (TextureUse& use : made_.material.textures)
      if (use.meaning == InputMeaning::metal_reflectance) use.input = MaterialInput::reflectance;
  }
  void make_clear(float ior, const Roughness& alpha, const Rgb& tint, bool is_thin) {
    model_.transmission_weight = 1;
    model_.base_color = model_.transmission_color = tint;
    model_.specular_ior = ior;
    model_.geometry_thin_walled = is_thin;
    set_alpha(alpha);
    made_.roughness_power = 0.5f;
  }

  /// OpenPBR's facets are wider along the tangent, which is turned where they are wider across.
  void set_alpha(const Roughness& alpha) {
    set_facets(model_, std::max(alpha.x, alpha.y), std::min(alpha.x, alpha.y));
    float& degrees = made_.material.tangent_degrees;
    if (alpha.x < alpha.y) degrees += degrees > 0 ? -90 : 90;
  }

  void take(const Lambert& model) { make_diffuse(model.reflectance); }
  void take(const RoughDiffuse& model) {
    name("diffuse surface", "diffuse surfaces");
    make_diffuse(model.reflectance);
  }
  void take(const DiffuseTransmission& model) {
    name("diffuse surface, through which no light goes", "diffuse surfaces, through which no light goes");
    make_diffuse(model.reflectance);
  }
  void take(const Hair& model) {
    name("diffuse surface", "diffuse surfaces");
    make_diffuse(model.reflectance);
  }
  void take(const Measured& model) {
    name("diffuse surface", "diffuse surfaces");
    make_diffuse(model.brdf->albedo());
  }
  void take(const Mirror& model) {
    name("smooth metal", "smooth metals");
    make_metal(model.reflectance, {});
  }
  void take(const Microfacet& model) {
    name("metal of its color and of GGX facets", "metals of their colors and of GGX facets");
    make_metal(reflected(model.eta, model.k), {model.alpha, model.alpha});
  }
  void take(const Conductor& model) {
    name("metal of its color", "metals of their colors");
    make_metal(reflected(model.eta, model.k) * model.reflectance, model.roughness);
  }
  void take(const CoatedConductor& model) {
    name("metal of its color below a clear coat", "metals of their colors below clear coats");
    make_metal(reflected(model.eta, model.k) * model.reflectance, model.roughness);
    model_.coat_weight = 1;
    model_.coat_roughness = std::sqrt(std::sqrt(model.coat_roughness.x * model.coat_roughness.y));
  }
  void take(const CoatedDiffuse& model) {
    name("glossy surface", "glossy surfaces");
    model_.base_color = model.reflectance;
    model_.specular_ior = model.ior;
    set_alpha(model.roughness);
    made_.roughness_power = 0.5f;
  }
  void take(const Dielectric& model) {
    if (model.reflectance != white) lose("the color of the reflection");
    make_clear(model.ior, model.roughness, model.transmittance, model.is_thin);
  }
  void take(const Glass& model) {
    if (model.reflectance != white) lose("the color of the reflection");
    make_clear(model.ior, {}, model.transmittance, false);
  }
  void take(const Refraction& model) {
    name("clear surface, which also reflects", "clear surfaces, which also reflect");
    make_clear(model.ior, {}, model.transmittance, false);
  }
  /// Of a shape that emits: else it is left out.
  void take(const Interface&) { make_diffuse({}); }
  void take(const Mix&) {}  // One of its materials was taken.
  void take(const Principled& model) {
    model_ = model;
    if (!has_texture(MaterialInput::reflectance)) {
      model_.base_color = model.base_color * model.base_weight;
      model_.base_weight = 1;
    }
    model_.emission_luminance = 0;
    if (model.base_diffuse_roughness != 0) lose("the roughness of the diffuse part");
    check_specular(model);
    check_facets(model);
    check_clear(model);
    check_coat(model);
    if (model.fuzz_weight > 0) check_fuzz(model);
  }

  /// The format's fuzz hides as much of what is below it as its brightest channel, OpenPBR's as its weight.
  void check_fuzz(const Principled& model) {
    const TextureUse* const color = texture_use(made_.material, MaterialInput::fuzz_color);
    if (color && color->meaning == InputMeaning::weighted_color) return;
    const float brightest = max_component(model.fuzz_color);
    if (!color && brightest >= 1) return;
    losses_.add("dark fuzz of a material hides less of what is below it",
                "dark fuzz of {} materials hides less of what is below it");
    if (!color) model_.fuzz_weight *= brightest;
  }

  /// What changes the specular reflection changes that of dielectrics alone (see without_metal() in
  /// io/gltf/writer_material.cpp).
  bool keeps_specular(MaterialInput input, const Rgb& value) const {
    const float metal = model_.base_metalness;
    if (std::find(spared_.begin(), spared_.end(), input) != spared_.end()) return true;
    if (has_texture(input)) return false;
    if (metal == 1 || has_texture(MaterialInput::base_metalness)) return value == white;
    return value.r >= metal && value.g >= metal && value.b >= metal;
  }
  void check_specular(const Principled& model) {
    if (model.base_metalness == 0 && !has_texture(MaterialInput::base_metalness)) return;
    if (!keeps_specular(MaterialInput::specular_weight, white * model.specular_weight) ||
        !keeps_specular(MaterialInput::specular_color, model.specular_color))
      lose("the metal's specular color");
  }

  /// By how much the format widens facets of the same anisotropy differs from roughness to roughness.
  void check_facets(const Principled& model) {
    if (model.specular_roughness_anisotropy == 0 || !has_texture(MaterialInput::roughness)) return;
    if (!has_texture(MaterialInput::specular_roughness_anisotropy))
      lose("the anisotropy beside a texture of the roughness");
    model_.specular_roughness_anisotropy = 0;
  }

  /// The texture of the color of light that goes through, or no_texture.
  std::uint32_t tint_texture() const {
    const TextureUse* const use = texture_use(made_.material, MaterialInput::transmission_color);
    return use && model_.transmission_depth == 0 ? use->texture : no_texture;
  }
  bool has_base_color(const Rgb& tint, std::uint32_t texture) const {
    const TextureUse* const base = texture_use(made_.material, MaterialInput::reflectance);
    if (!base) return texture == no_texture && tint == model_.base_color;
    return base->texture == texture && model_.base_weight == 1;
  }
  void set_base_color(const Rgb& color, std::uint32_t texture) {
    model_.base_color = model_.transmission_color = color;
    model_.base_weight = 1;
    std::vector<TextureUse>& uses = made_.material.textures;
    std::erase_if(uses, [](const TextureUse& use) { return use.input == MaterialInput::reflectance; });
    if (texture != no_texture) uses.push_back({MaterialInput::reflectance, texture});
  }

  /// Light that goes through is times the base color, which the diffuse part and the metal have, too.
  void check_clear(const Principled& model) {
    const bool has_metal_texture = has_texture(MaterialInput::base_metalness);
    const bool is_metal = model.base_metalness == 1 && !has_metal_texture;
    if (model.transmission_weight == 0 || is_metal) return;
    const Rgb tint = model.transmission_depth > 0 ? white : model.transmission_color;
    const std::uint32_t texture = tint_texture();
    if (has_base_color(tint, texture)) return;
    if (model.transmission_weight < 1 || has_texture(MaterialInput::transmission_weight))
      lose("the color of the diffuse part, which is that of the clear part,");
    if (model.base_metalness > 0 || has_metal_texture)
      lose("the color of the metal, which is that of the clear part,");
    set_base_color(tint, texture);
  }
  void check_coat(const Principled& model) {
    if (model.coat_weight == 0) return;
    if (model.coat_color != white) lose("the color of the coat");
    if (model.coat_ior != 1.5f) lose("the coat's index, which is 1.5 there,");
    if (model.coat_darkening != 0) lose("what the coat reflects back to the base, which darkens it,");
  }

  const Material& material_;
  const std::vector<MaterialInput>& spared_;
  Losses& losses_;
  Principled model_;
  GltfStandIn made_;
};

/// Whether a texture is how much of a material is metal.
bool is_metalness(std::span<const Texture> textures, std::uint32_t texture, const Material& material) {
  if (const TextureUse* use = texture_use(material, MaterialInput::base_metalness))
    return use->texture == texture;
  const auto* constant = std::get_if<ConstantTexture>(&textures[texture].model);
  const auto* model = std::get_if<Principled>(&material.model);
  return constant && model && constant->value == white * model->base_metalness;
}

PlainMaterial without_spared_metal(const Scene& scene, Material material) {
  std::vector<MaterialInput> spared;
  for (const MaterialInput input : {MaterialInput::specular_weight, MaterialInput::specular_color}) {
    TextureUse* const use = texture_use(material, input);
    const auto* mix = use ? std::get_if<MixTexture>(&scene.textures[use->texture].model) : nullptr;
    if (!mix || !is_metalness(scene.textures, mix->amount, material)) continue;
    const auto* lifted = std::get_if<ConstantTexture>(&scene.textures[mix->second].model);
    if (!lifted || lifted->value != white) continue;
    spared.push_back(input);
    use->texture = mix->first;
    const auto* constant = std::get_if<ConstantTexture>(&scene.textures[mix->first].model);
    if (!constant) continue;
    auto& model = std::get<Principled>(material.model);
    if (input == MaterialInput::specular_weight)
      model.specular_weight = constant->value.r;
    else
      model.specular_color = constant->value;
    material.textures.erase(material.textures.begin() + (use - material.textures.data()));
  }
  return {std::move(material), std::move(spared)};
}

/// Of a mixture the part that most of its points show.
std::uint32_t unmixed(const Scene& scene, std::uint32_t material, Losses& losses) {
  const auto* mix = std::get_if<Mix>(&scene.materials[material].model);
  if (!mix) return material;
  losses.add("a mixture of materials is the one that it has more of",
             "{} mixtures of materials are the ones that they have more of");
  return unmixed(scene, mix->amount >= 0.5f ? mix->second : mix->first, losses);
}

}  // namespace

GltfStandIn gltf_stand_in(const Scene& scene, std::uint32_t material, Losses& losses) {
  const Material& own = scene.materials[unmixed(scene, material, losses)];
  if (has_subsurface(own))
    losses.add("light below the surface of a material is left out",
               "light below the surfaces of {} materials is left out");
  const PlainMaterial plain = without_spared_metal(scene, with_one_base(own, losses));
  return StandIn(plain, losses).make();
}

}  // namespace twinray
