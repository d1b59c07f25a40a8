// SPDX-License-Identifier: Apache-2.0
#include "core/textured_material.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/subsurface.h"

namespace twinray {
namespace {

constexpr float most_eta = 1000;
constexpr float most_thickness = 1000;

float unit(float x) { return x > 0 ? std::min(x, 1.0f) : 0; }

/// A texture's value, as an input takes it.
struct Value {
  Rgb color;
  InputMeaning meaning;

  float number() const {
    return meaning == InputMeaning::squared_roughness ? alpha_of_roughness(color.r) : unit(color.r);
  }
  /// Of a reflectance or the like.
  Rgb unit_color() const { return {unit(color.r), unit(color.g), unit(color.b)}; }
  /// Of eta or k.
  Rgb metal_color() const {
    if (meaning == InputMeaning::metal_reflectance) return metal_k(color);
    const auto positive = [](float x) { return x > 0 ? std::min(x, most_eta) : 0; };
    return {positive(color.r), positive(color.g), positive(color.b)};
  }
  /// Of a film, in micrometers.
  float thickness() const { return color.r > 0 ? std::min(color.r, most_thickness) : 0; }
};

void assign(Rgb& target, const Value& value) { target = value.unit_color(); }
void assign(float& target, const Value& value) { target = value.number(); }
void assign(Roughness& target, const Value& value) {
  const float alpha = value.number();
  target = {alpha, alpha};
}

/// A member of eta or k, whose range is another.
struct MetalColor {
  Rgb& color;
};
void assign(MetalColor target, const Value& value) { target.color = value.metal_color(); }

/// In micrometers.
struct Thickness {
  float& micrometers;
};
void assign(Thickness target, const Value& value) { target.micrometers = value.thickness(); }

/// The members that Principled alone has.
template <typename Use>
bool with_principled_input(Principled& model, MaterialInput input, const Use& use) {
  switch (input) {
    case MaterialInput::base_weight:
      return use(model.base_weight), true;
    case MaterialInput::base_diffuse_roughness:
      return use(model.base_diffuse_roughness), true;
    case MaterialInput::base_metalness:
      return use(model.base_metalness), true;
    case MaterialInput::subsurface_weight:
      return use(model.subsurface_weight), true;
    case MaterialInput::specular_weight:
      return use(model.specular_weight), true;
    case MaterialInput::roughness:
      return use(model.specular_roughness), true;
    case MaterialInput::specular_roughness_anisotropy:
      return use(model.specular_roughness_anisotropy), true;
    case MaterialInput::transmission_weight:
      return use(model.transmission_weight), true;
    case MaterialInput::coat_weight:
      return use(model.coat_weight), true;
    case MaterialInput::coat_roughness:
      return use(model.coat_roughness), true;
    case MaterialInput::coat_darkening:
      return use(model.coat_darkening), true;
    case MaterialInput::fuzz_weight:
      return use(model.fuzz_weight), true;
    case MaterialInput::fuzz_roughness:
      return use(model.fuzz_roughness), true;
    case MaterialInput::thin_film_weight:
      return use(model.thin_film_weight), true;
    case MaterialInput::reflectance:
      return use(model.base_color), true;
    case MaterialInput::subsurface_color:
      return use(model.subsurface_color), true;
    case MaterialInput::specular_color:
      return use(model.specular_color), true;
    case MaterialInput::transmission_color:
      return use(model.transmission_color), true;
    case MaterialInput::coat_color:
      return use(model.coat_color), true;
    case MaterialInput::fuzz_color:
      return use(model.fuzz_color), true;
    case MaterialInput::thin_film_thickness:
      return use(Thickness{model.thin_film_thickness}), true;
    default:
      return false;
  }
}

/// The inputs of a roughness of two axes.
struct RoughnessInputs {
  MaterialInput both, x, y;
};
constexpr RoughnessInputs surface_roughness{MaterialInput::roughness, MaterialInput::roughness_u,
                                            MaterialInput::roughness_v};
constexpr RoughnessInputs coat_roughness{MaterialInput::coat_roughness, MaterialInput::coat_roughness_u,
                                         MaterialInput::coat_roughness_v};

template <typename Use>
bool with_roughness(Roughness& roughness, MaterialInput input, const RoughnessInputs& inputs,
                    const Use& use) {
  if (input == inputs.both) return use(roughness), true;
  if (input == inputs.x) return use(roughness.x), true;
  if (input == inputs.y) return use(roughness.y), true;
  return false;
}

/// Gives the member of that name to `use`; false where the model has none.
template <typename Model, typename Use>
bool with_input(Model& model, MaterialInput input, const Use& use) {
  if constexpr (requires { model.base_color; }) return with_principled_input(model, input, use);
  if constexpr (requires { model.reflectance; })
    if (input == MaterialInput::reflectance) return use(model.reflectance), true;
  if constexpr (requires { model.transmittance; })
    if (input == MaterialInput::transmittance) return use(model.transmittance), true;
  if constexpr (requires { model.roughness.x; })
    if (with_roughness(model.roughness, input, surface_roughness, use)) return true;
  if constexpr (std::is_same_v<Model, RoughDiffuse> || std::is_same_v<Model, Glass> ||
                std::is_same_v<Model, Refraction>)
    if (input == MaterialInput::roughness) return use(model.roughness), true;
  if constexpr (requires { model.coat_roughness.x; })
    if (with_roughness(model.coat_roughness, input, coat_roughness, use)) return true;
  if constexpr (requires { model.amount; })
    if (input == MaterialInput::amount) return use(model.amount), true;
  if constexpr (requires { model.k; }) {
    if (input == MaterialInput::eta) return use(MetalColor{model.eta}), true;
    if (input == MaterialInput::k) return use(MetalColor{model.k}), true;
  }
  return false;
}

}  // namespace

const char* input_name(MaterialInput input) {
  constexpr const char* names[] = {"reflectance",
                                   "transmittance",
                                   "roughness",
                                   "roughness_u",
                                   "roughness_v",
                                   "coat_roughness",
                                   "coat_roughness_u",
                                   "coat_roughness_v",
                                   "amount",
                                   "eta",
                                   "k",
                                   "base_weight",
                                   "base_diffuse_roughness",
                                   "base_metalness",
                                   "subsurface_weight",
                                   "subsurface_color",
                                   "specular_weight",
                                   "specular_color",
                                   "specular_roughness_anisotropy",
                                   "transmission_weight",
                                   "transmission_color",
                                   "coat_weight",
                                   "coat_color",
                                   "coat_darkening",
                                   "fuzz_weight",
                                   "fuzz_color",
                                   "fuzz_roughness",
                                   "thin_film_weight",
                                   "thin_film_thickness"};
  static_assert(std::size(names) == material_inputs);
  return names[std::size_t(input)];
}

bool has_input(const SurfaceModel& model, MaterialInput input) {
  SurfaceModel copy = model;
  return std::visit([&](auto& m) { return with_input(m, input, [](const auto&) {}); }, copy);
}

Rgb metal_k(const Rgb& reflectance) {
  const auto k = [](float r) {
    const float most = r > 0 ? std::min(r, 0.9999f) : 0;
    return 2 * std::sqrt(most) / std::sqrt(1 - most);
  };
  return {k(reflectance.r), k(reflectance.g), k(reflectance.b)};
}

float alpha_of_roughness(float roughness) { return std::sqrt(unit(roughness)); }

void set_facets(Principled& model, float along, float across) {
  const float ratio = along > 0 ? across / along : 1;
  model.specular_roughness_anisotropy = 1 - ratio;
  model.specular_roughness = std::min(1.0f, std::sqrt(along * std::sqrt((1 + ratio * ratio) / 2)));
}

void widen(Principled& model, float strength) {
  const float across = model.specular_roughness * model.specular_roughness;
  set_facets(model, across + (1 - across) * strength * strength, across);
}

void set_fuzz(Principled& model, const Rgb& weighted_color) {
  model.fuzz_weight = max_component(weighted_color);
  model.fuzz_color = model.fuzz_weight > 0 ? weighted_color / model.fuzz_weight : weighted_color;
}

SurfaceModel textured_model(const Material& material, std::span<const Texture> textures,
                            const TexturePoint& at) {
  SurfaceModel model = material.model;
  std::optional<float> widening;
  bool has_emerging = false;
  for (const TextureUse& use : material.textures) {
    const Value value{evaluate(textures, use.texture, at), use.meaning};
    if (use.meaning == InputMeaning::widening) {
      widening = value.number();
      continue;
    }
    has_emerging = has_emerging || use.meaning == InputMeaning::emerging;
    if (use.meaning == InputMeaning::weighted_color) {
      set_fuzz(std::get<Principled>(model), value.unit_color());
      continue;
    }
    std::visit([&](auto& m) { with_input(m, use.input, [&](auto&& member) { assign(member, value); }); },
               model);
  }
  if (widening) widen(std::get<Principled>(model), *widening);
  if (auto* const coated = std::get_if<CoatedDiffuse>(&model); coated && has_emerging)
    coated->reflectance = base_of_emerging(*coated, coated->reflectance);
  return model;
}

}  // namespace twinray
