// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/inputs.h"

#include <fmt/format.h>

#include "io/gltf/context.h"

namespace twinray {

bool GltfInputs::can_use(const GltfSlot& slot) const {
  if (!slot) return false;
  if (slot.uv_set == uv_set) return true;
  context.warn(slot.pointer,
               uv_set < 0 ? fmt::format("the mesh has no TEXCOORD_{}; this texture is left out", slot.uv_set)
                          : fmt::format("one set of texture coordinates is rendered, here TEXCOORD_{}; this "
                                        "texture goes by TEXCOORD_{}, and is left out",
                                        uv_set, slot.uv_set));
  return false;
}

void GltfInputs::color(MaterialInput input, const GltfSlot& slot, const Rgb& factor) {
  if (!can_use(slot)) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::color, PictureChannels::color});
  material.textures.push_back({input, textures.scaled(picture, factor)});
}

void GltfInputs::number(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float factor) {
  if (!can_use(slot)) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::data, channel});
  material.textures.push_back({input, textures.scaled(picture, {factor, factor, factor})});
}

void GltfInputs::between(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float at_0,
                         float at_1) {
  if (!can_use(slot)) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::data, channel});
  const std::uint32_t first = textures.constant(white * at_0), second = textures.constant(white * at_1);
  material.textures.push_back({input, textures.add("", MixTexture{first, second, picture})});
}

}  // namespace twinray
