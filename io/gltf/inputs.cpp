// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/inputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/gltf/context.h"

namespace twinray {

bool GltfInputs::is_missing(int set) const {
  return std::find(missing_sets.begin(), missing_sets.end(), set) != missing_sets.end();
}

bool GltfInputs::can_use(const GltfSlot& slot) const {
  if (!slot) return false;
  if (slot.uv_set == uv_set) return true;
  const std::string fault =
      is_missing(slot.uv_set)
          ? fmt::format("the mesh has no TEXCOORD_{}; this texture is left out", slot.uv_set)
      : uv_set < 0 ? fmt::format(
                         "the mesh has no coordinates of the material's first texture; so this one, of "
                         "TEXCOORD_{}, is left out, too",
                         slot.uv_set)
                   : fmt::format(
                         "a texture of this kind must go by the coordinates of most, here "
                         "TEXCOORD_{}; this one goes by TEXCOORD_{}, and is left out",
                         uv_set, slot.uv_set);
  context.warn(slot.pointer, fault);
  return false;
}

std::optional<CoordinateSet> GltfInputs::coordinates(const GltfSlot& slot) const {
  if (!slot) return std::nullopt;
  if (uv_set >= 0 && slot.uv_set == second_uv_set) return CoordinateSet::second;
  if (is_missing(slot.uv_set) || uv_set < 0 || second_uv_set < 0 || slot.uv_set == uv_set)
    return can_use(slot) ? std::optional(CoordinateSet::first) : std::nullopt;
  context.warn(slot.pointer,
               fmt::format("two sets of texture coordinates are rendered, here TEXCOORD_{} and TEXCOORD_{}; "
                           "this texture goes by TEXCOORD_{}, and is left out",
                           uv_set, second_uv_set, slot.uv_set));
  return std::nullopt;
}

void GltfInputs::color(MaterialInput input, const GltfSlot& slot, const Rgb& factor) {
  const auto set = coordinates(slot);
  if (!set) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::color, PictureChannels::color}, *set);
  material.textures.push_back({input, textures.scaled(picture, factor)});
}

void GltfInputs::number(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float factor) {
  const auto set = coordinates(slot);
  if (!set) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::data, channel}, *set);
  material.textures.push_back({input, textures.scaled(picture, {factor, factor, factor})});
}

void GltfInputs::between(MaterialInput input, const GltfSlot& slot, PictureChannels channel, float at_0,
                         float at_1) {
  const auto set = coordinates(slot);
  if (!set) return;
  const std::uint32_t picture = textures.picture(slot, {PictureRole::data, channel}, *set);
  const std::uint32_t first = textures.constant(white * at_0), second = textures.constant(white * at_1);
  material.textures.push_back({input, textures.add("", MixTexture{first, second, picture})});
}

}  // namespace twinray
