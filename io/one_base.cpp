// SPDX-License-Identifier: Apache-2.0
#include "io/one_base.h"

namespace twinray {

Material with_one_base(const Material& material, Losses& losses) {
  Material one = material;
  auto* const model = std::get_if<Principled>(&one.model);
  if (!model) return one;
  const float weight = model->subsurface_weight;
  const bool is_below = weight >= 0.5f;
  if (texture_use(material, MaterialInput::subsurface_weight) || (weight > 0 && weight < 1))
    losses.add("the lesser of the two diffuse parts of a material is left out",
               "the lesser of the two diffuse parts of {} materials is left out");
  const auto is_other = [&](const TextureUse& use) {
    using enum MaterialInput;
    if (use.input == subsurface_weight) return true;
    return is_below ? use.input == reflectance || use.input == base_weight : use.input == subsurface_color;
  };
  std::erase_if(one.textures, is_other);
  if (is_below) model->base_color = model->subsurface_color, model->base_weight = 1;
  for (TextureUse& use : one.textures)
    if (use.input == MaterialInput::subsurface_color) use.input = MaterialInput::reflectance;
  model->subsurface_weight = 0;
  if (!is_below) one.subsurface = {};
  return one;
}

}  // namespace twinray
