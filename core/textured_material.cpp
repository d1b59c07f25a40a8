// SPDX-License-Identifier: Apache-2.0
#include "core/textured_material.h"

#include <algorithm>

namespace twinray {
namespace {

float unit(float x) { return std::clamp(x, 0.0f, 1.0f); }

void assign(Rgb& target, const Rgb& value) { target = {unit(value.r), unit(value.g), unit(value.b)}; }
void assign(float& target, const Rgb& value) { target = unit(value.r); }
void assign(Roughness& target, const Rgb& value) { target = {unit(value.r), unit(value.r)}; }

/// Gives the member of that name to `use`; false where the model has none.
template <typename Model, typename Use>
bool with_input(Model& model, MaterialInput input, const Use& use) {
  if constexpr (requires { model.reflectance; })
    if (input == MaterialInput::reflectance) return use(model.reflectance), true;
  if constexpr (requires { model.base_color; })
    if (input == MaterialInput::reflectance) return use(model.base_color), true;
  if constexpr (requires { model.transmittance; })
    if (input == MaterialInput::transmittance) return use(model.transmittance), true;
  if constexpr (requires { model.roughness; })
    if (input == MaterialInput::roughness) return use(model.roughness), true;
  if constexpr (requires { model.specular_roughness; })
    if (input == MaterialInput::roughness) return use(model.specular_roughness), true;
  if constexpr (requires { model.amount; })
    if (input == MaterialInput::amount) return use(model.amount), true;
  return false;
}

}  // namespace

const char* input_name(MaterialInput input) {
  constexpr const char* names[] = {"reflectance", "transmittance", "roughness", "amount"};
  return names[std::size_t(input)];
}

bool has_input(const SurfaceModel& model, MaterialInput input) {
  return std::visit([&](const auto& m) { return with_input(m, input, [](const auto&) {}); }, model);
}

SurfaceModel textured_model(const Material& material, std::span<const Texture> textures,
                            const TexturePoint& at) {
  SurfaceModel model = material.model;
  for (const TextureUse& use : material.textures) {
    const Rgb value = evaluate(textures, use.texture, at);
    std::visit([&](auto& m) { with_input(m, use.input, [&](auto& member) { assign(member, value); }); },
               model);
  }
  return model;
}

}  // namespace twinray
