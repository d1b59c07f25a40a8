// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "core/texture.h"

namespace twinray {

/// Adds base + gain t of a texture t, channel by channel, and returns its index. It is the half of 2 base and
/// of 2 gain t: the steps by two round nothing.
std::uint32_t add_affine(std::vector<Texture>& textures, std::uint32_t texture, const Rgb& gain,
                         const Rgb& base);

/// Adds a normal map whose normals lean as far along its red and green as those of `map` times a factor each,
/// and returns its index: `map` itself where both factors are 1.
std::uint32_t add_leaning(std::vector<Texture>& textures, std::uint32_t map, float red, float green);

}  // namespace twinray
