// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <variant>

#include "core/texture_model.h"

namespace twinray {

/// Calls of(index) for each texture that one of a kind names, as often as it does.
template <typename Model, typename Of>
void for_each_part(const Model& texture, const Of& of) {
  if constexpr (requires { texture.first; }) of(texture.first), of(texture.second);
  if constexpr (requires { texture.amount; }) of(texture.amount);
  if constexpr (requires { texture.texture; }) of(texture.texture);
}

/// The same for a texture of whatever kind.
template <typename Of>
void for_each_part(const TextureModel& model, const Of& of) {
  std::visit([&](const auto& texture) { for_each_part(texture, of); }, model);
}

}  // namespace twinray
