// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/material_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/microfacet.h"
#include "core/textured_material.h"

namespace twinray {
namespace {

/// Names of inputs that are not pbrt's own, or stand for others; all else is called as in core/material.h.
struct InputAlias {
  std::string_view name;
  MaterialInput input;
};
constexpr InputAlias input_aliases[] = {{"base_color", MaterialInput::reflectance},
                                        {"specular_roughness", MaterialInput::roughness},
                                        {"conductor.eta", MaterialInput::eta},
                                        {"conductor.k", MaterialInput::k}};

std::optional<MaterialInput> input_named(std::string_view name) {
  for (const InputAlias& alias : input_aliases)
    if (alias.name == name) return alias.input;
  for (int i = 0; i < material_inputs; ++i)
    if (input_name(MaterialInput(i)) == name) return MaterialInput(i);
  return std::nullopt;
}

}  // namespace

Rgb PbrtMaterialInputs::color(const char* name, const Rgb& fallback, ColorRole role) const {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return fallback;
  if (found->type != PbrtType::texture) return color_of(parameters, *found, role, context.files);
  const Rgb mean = use(*found, PictureChannels::color, input_named(name)).mean;
  return role == ColorRole::reflectance ? within_unit(mean) : mean;
}

Rgb PbrtMaterialInputs::color(const char* name, const Rgb& fallback, MaterialInput input,
                              InputMeaning meaning) const {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return fallback;
  if (found->type != PbrtType::texture)
    return color_of(parameters, *found, ColorRole::reflectance, context.files);
  return within_unit(use(*found, PictureChannels::color, input, meaning).mean);
}

float PbrtMaterialInputs::number(const char* name, float fallback) const {
  const PbrtParameter* found = parameters.find(name);
  if (!found || found->type != PbrtType::texture) return parameters.real(name, fallback);
  return use(*found, PictureChannels::number, input_named(name)).mean.r;
}

float PbrtMaterialInputs::mean_number(const char* name, float fallback, const NumberRange& range) const {
  const PbrtParameter* found = parameters.find(name);
  if (!found || found->type != PbrtType::texture) return parameters.real(name, fallback, range);
  const float mean = use(*found, PictureChannels::number, std::nullopt).mean.r;
  return std::clamp(mean, float(range.least), float(range.most));
}

Rgb PbrtMaterialInputs::k_of_reflectance(const PbrtParameter& reflectance) const {
  if (reflectance.type != PbrtType::texture)
    return metal_k(color_of(parameters, reflectance, ColorRole::reflectance, context.files));
  return metal_k(
      use(reflectance, PictureChannels::color, MaterialInput::k, InputMeaning::metal_reflectance).mean);
}

float PbrtMaterialInputs::ior(const char* name) const {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return 1.5f;
  const Rgb color = color_of(parameters, *found, ColorRole::unbounded, context.files);
  // The weights of a grey color's channels would round it.
  const float value = color.r == color.g && color.g == color.b ? color.r : luminance(color);
  // 1000 is how glTF says that all is reflected.
  if (!(value > 0 && value <= 1000))
    found->place.fail(fmt::format("\"{}\" is {:g}; an index of refraction lies in (0, 1000]", name, value));
  return value;
}

float PbrtMaterialInputs::coat_ior(const char* name) const {
  const float value = ior(name);
  if (value < 1)
    parameters.find(name)->place.warn(
        context.warnings, fmt::format("a coat of the index {:g} is not rendered: it is taken as 1", value));
  return value;
}

Roughness PbrtMaterialInputs::roughness(const std::string& prefix, MaterialInput input) const {
  const PbrtParameter* both = parameters.find((prefix + "roughness").c_str());
  const PbrtParameter* u = parameters.find((prefix + "uroughness").c_str());
  const PbrtParameter* v = parameters.find((prefix + "vroughness").c_str());
  const auto next = [&](int steps) { return MaterialInput(int(input) + steps); };
  const bool is_even = !u && !v;
  const float x = axis(u ? u : both, is_even ? input : next(1));
  const float y = is_even ? x : axis(v ? v : both, next(2));
  return std::max(x, y) < least_alpha ? Roughness{} : Roughness{x, y};
}

const PbrtTextures::Named& PbrtMaterialInputs::use(const PbrtParameter& parameter, PictureChannels kind,
                                                   std::optional<MaterialInput> input,
                                                   InputMeaning meaning) const {
  const PbrtTextures::Named& texture = textures.named(parameters, parameter, kind);
  if (input)
    uses.push_back({*input, texture.index, meaning});
  else
    parameter.place.warn(
        context.warnings,
        fmt::format("a texture of \"{}\" is not rendered here: its mean stands for it", parameter.name));
  return texture;
}

float PbrtMaterialInputs::axis(const PbrtParameter* found, MaterialInput input) const {
  const bool is_remapped = parameters.flag("remaproughness", true);
  const auto meaning = is_remapped ? InputMeaning::squared_roughness : InputMeaning::value;
  if (!found) return 0;
  const bool is_texture = found->type == PbrtType::texture;
  const float roughness = is_texture ? use(*found, PictureChannels::number, input, meaning).mean.r
                                     : parameters.real(found->name.c_str(), 0);
  if (!(roughness >= 0 && roughness <= 1))
    found->place.warn(context.warnings,
                      fmt::format("a roughness of {:g} is taken as the nearest one in [0, 1]", roughness));
  const float in_range = std::clamp(roughness, 0.0f, 1.0f);
  return is_remapped ? alpha_of_roughness(in_range) : in_range;
}

}  // namespace twinray
