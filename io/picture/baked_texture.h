// SPDX-License-Identifier: Apache-2.0
// Textures that are made of others as one picture, for formats that have no more than pictures.
//
// Pictures and boards that lie over the surface in the same way are drawn into a picture that lies as they
// do; where they lie in different ways, into one over the unit square of the surface's own coordinates. What
// goes by the points of the scene is its mean there.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/image.h"
#include "core/texture.h"

namespace twinray {

struct BakedTexture {
  Image picture;
  UvTransform uv;  ///< From the surface's coordinates to the picture's.
  Wrap wrap;
  TextureFilter filter = TextureFilter::bilinear;
  /// Whether it shows what the texture does, but for how it is filtered; else it may differ, above all beside
  /// the unit square.
  bool is_exact = true;
};

BakedTexture bake(std::span<const Texture> textures, std::uint32_t index);

/// Several textures in one frame, such as the channels of one picture: picture k has the values of
/// indices[k], and all have the size of the largest. The rest is that of all of them together.
struct BakedTextures {
  std::vector<Image> pictures;
  BakedTexture frame;  ///< Without a picture.
};
BakedTextures bake_together(std::span<const Texture> textures, std::span<const std::uint32_t> indices);

}  // namespace twinray
