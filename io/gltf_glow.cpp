// SPDX-License-Identifier: Apache-2.0
#include "io/gltf_glow.h"

#include <algorithm>
#include <cmath>

#include "core/texture.h"

namespace twinray {
namespace {

/// What exporters' rounding leaves beside the square.
constexpr float margin = 1e-3f;

bool is_identity(const UvTransform& uv) {
  const UvTransform identity;
  return std::equal(&uv.m[0][0], &uv.m[0][0] + 6, &identity.m[0][0]);
}

bool are_within(std::span<const Vec2> uvs) {
  return std::all_of(uvs.begin(), uvs.end(), [](Vec2 uv) {
    return uv.x >= -margin && uv.x <= 1 + margin && uv.y >= -margin && uv.y <= 1 + margin;
  });
}

/// The picture as it lies over the unit square, in its own resolution.
Image resampled(const Image& picture, const UvTransform& uv, WrapMode wrap) {
  constexpr float most = 4096;
  const float wide = float(picture.width) * std::max(std::fabs(uv.m[0][0]), std::fabs(uv.m[0][1]));
  const float high = float(picture.height) * std::max(std::fabs(uv.m[1][0]), std::fabs(uv.m[1][1]));
  Image image(int(std::clamp(std::ceil(wide), 1.0f, most)), int(std::clamp(std::ceil(high), 1.0f, most)));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec2 center{(float(x) + 0.5f) / float(image.width), 1 - (float(y) + 0.5f) / float(image.height)};
      image.at(x, y) = bilinear(MipLevel(picture), wrap, uv(center));
    }
  return image;
}

}  // namespace

std::shared_ptr<const Image> glow_over(const GltfSurface& surface, std::span<const Vec2> uvs) {
  if (!are_within(uvs)) return nullptr;
  if (is_identity(surface.glow_uv)) return surface.glow;
  const WrapMode wrap = surface.glow_repeats ? WrapMode::repeat : WrapMode::clamp;
  return std::make_shared<const Image>(resampled(*surface.glow, surface.glow_uv, wrap));
}

}  // namespace twinray
