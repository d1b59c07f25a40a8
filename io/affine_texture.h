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

}  // namespace twinray
