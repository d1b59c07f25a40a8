// SPDX-License-Identifier: Apache-2.0
// Textures that are computed where they are asked for. None is inlined where pictures are looked up, which
// most textures are.
#pragma once
#include "core/texture_model.h"

namespace twinray {

/// Which of two textures shows at a point.
bool shows_first(const CheckerboardTexture& texture, const TexturePoint& at);
bool shows_first(const CubesTexture& texture, const TexturePoint& at);
bool shows_first(const DotsTexture& texture, const TexturePoint& at);

Rgb value_of_pattern(const BilinearTexture& texture, const TexturePoint& at);
Rgb value_of_pattern(const NoiseTexture& texture, const TexturePoint& at);

}  // namespace twinray
