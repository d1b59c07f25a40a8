// SPDX-License-Identifier: Apache-2.0
#include "io/affine_texture.h"

namespace twinray {

std::uint32_t add_affine(std::vector<Texture>& textures, std::uint32_t texture, const Rgb& gain,
                         const Rgb& base) {
  const auto add = [&](const TextureModel& model) {
    textures.push_back({"", model});
    return std::uint32_t(textures.size() - 1);
  };
  const std::uint32_t slope = add(ScaleTexture{texture, add(ConstantTexture{gain * 2})});
  const std::uint32_t offset = add(ConstantTexture{base * 2});
  return add(MixTexture{offset, slope, add(ConstantTexture{white * 0.5f})});
}

std::uint32_t add_leaning(std::vector<Texture>& textures, std::uint32_t map, float red, float green) {
  if (red == 1 && green == 1) return map;
  return add_affine(textures, map, {red, green, 1}, Rgb{1 - red, 1 - green, 0} * 0.5f);
}

}  // namespace twinray
