// SPDX-License-Identifier: Apache-2.0
#include "io/one_base.h"

namespace twinray {

Material with_one_base(const Material& material) {
  Material one = material;
  auto* const model = std::get_if<Principled>(&one.model);
  if (!model) return one;
  const bool is_below = model->subsurface_weight >= 0.5f;
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
