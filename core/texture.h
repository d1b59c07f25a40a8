// SPDX-License-Identifier: Apache-2.0
// Looking up textures.
#pragma once
#include <cstdint>
#include <span>

#include "core/texture_model.h"

namespace twinray {

/// The value of a picture at a point: bilinear of the four pixels around. Black where the point is not
/// finite.
Rgb bilinear(const MipLevel& image, Wrap wrap, Vec2 uv);
/// That of the pixel at a point; likewise.
Rgb nearest(const MipLevel& image, Wrap wrap, Vec2 uv);

/// The value of a texture of a scene. The same bits on every machine.
Rgb evaluate(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at);

/// Asks memory for the texels that evaluate() reads there, so that they are near when it comes: many lookups
/// wait for memory at once. Texels in tiles are not asked for.
void prefetch_texels(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at);

}  // namespace twinray
