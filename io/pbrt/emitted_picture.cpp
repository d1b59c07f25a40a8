// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/emitted_picture.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// What exporters' rounding leaves beside the square.
constexpr float margin = 1e-3f;

bool lies_as_in_pbrt(const MeshLight& light) {
  return light.uv == UvTransform{} && light.filter != TextureFilter::nearest;
}

/// So many pixels of a row or column, as a transform repeats a picture of `size`: no more than 16 times.
int repeated(int size, float times) {
  const float most = std::min(4096.0f, 16 * float(size));
  return int(std::clamp(std::ceil(float(size) * times), 1.0f, most));
}

/// The same of a picture whose pixels do not fall on pixels again: small ones are divided, until nobody sees
/// it.
int divided(int count) {
  constexpr int least = 256;
  while (count < least) count *= 2;
  return count;
}

/// Whether a transform of a picture moves it by whole pixels, and repeats it whole times.
bool keeps_pixels(const MeshLight& light) {
  const auto& [u, v] = light.uv.m;
  const auto is_whole = [](float x) { return std::fabs(x - std::round(x)) < margin; };
  return light.filter != TextureFilter::nearest && u[1] == 0 && v[0] == 0 && is_whole(u[0]) &&
         is_whole(v[1]) && is_whole(u[2] * float(light.picture->width)) &&
         is_whole(v[2] * float(light.picture->height));
}

}  // namespace

std::shared_ptr<const Image> emitted_picture(const MeshLight& light) {
  if (lies_as_in_pbrt(light)) return light.picture;
  const Image& picture = *light.picture;
  const auto& [u, v] = light.uv.m;
  const int columns = repeated(picture.width, std::max(std::fabs(u[0]), std::fabs(u[1])));
  const int rows = repeated(picture.height, std::max(std::fabs(v[0]), std::fabs(v[1])));
  const bool is_kept = keeps_pixels(light);
  const auto& lookup = light.filter == TextureFilter::nearest ? nearest : bilinear;
  auto drawn = std::make_shared<Image>(is_kept ? columns : divided(columns), is_kept ? rows : divided(rows));
  for (int y = 0; y < drawn->height; ++y)
    for (int x = 0; x < drawn->width; ++x) {
      const Vec2 center{(float(x) + 0.5f) / float(drawn->width),
                        1 - (float(y) + 0.5f) / float(drawn->height)};
      drawn->at(x, y) = lookup(MipLevel(picture), light.wrap, light.uv(center));
    }
  return drawn;
}

bool is_emitted_whole(const MeshLight& light, std::span<const Vec2> uvs) {
  if (lies_as_in_pbrt(light) && light.wrap == WrapMode::clamp) return true;
  return std::all_of(uvs.begin(), uvs.end(), [](Vec2 uv) {
    return uv.x >= -margin && uv.x <= 1 + margin && uv.y >= -margin && uv.y <= 1 + margin;
  });
}

}  // namespace twinray
