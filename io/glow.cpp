// SPDX-License-Identifier: Apache-2.0
#include "io/glow.h"

#include <algorithm>
#include <cmath>
#include <span>

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
bool keeps_pixels(const UvTransform& uv, int width, int height) {
  const auto is_whole = [](float x) { return std::fabs(x - std::round(x)) < margin; };
  return uv.m[0][1] == 0 && uv.m[1][0] == 0 && is_whole(uv.m[0][0]) && is_whole(uv.m[1][1]) &&
         is_whole(uv.m[0][2] * float(width)) && is_whole(uv.m[1][2] * float(height));
}

/// The picture as it lies over the unit square, in its own resolution or a finer one.
Image resampled(const Image& picture, const UvTransform& uv, Wrap wrap) {
  const int columns = repeated(picture.width, std::max(std::fabs(uv.m[0][0]), std::fabs(uv.m[0][1])));
  const int rows = repeated(picture.height, std::max(std::fabs(uv.m[1][0]), std::fabs(uv.m[1][1])));
  const bool is_kept = keeps_pixels(uv, picture.width, picture.height);
  Image image(is_kept ? columns : divided(columns), is_kept ? rows : divided(rows));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec2 center{(float(x) + 0.5f) / float(image.width), 1 - (float(y) + 0.5f) / float(image.height)};
      image.at(x, y) = bilinear(MipLevel(picture), wrap, uv(center));
    }
  return image;
}

/// Moves the texture coordinates of each triangle by whole numbers, towards the unit square.
void move_into_square(Mesh& mesh) {
  if (are_within(mesh.uvs)) return;
  std::vector<Vec2> moved;
  moved.reserve(3 * mesh.uv_indices.size());
  for (Triangle& triangle : mesh.uv_indices) {
    const Vec2 &a = mesh.uvs[triangle[0]], &b = mesh.uvs[triangle[1]], &c = mesh.uvs[triangle[2]];
    const float u = std::floor(std::min({a.x, b.x, c.x}) + margin);
    const float v = std::floor(std::min({a.y, b.y, c.y}) + margin);
    const auto first = std::uint32_t(moved.size());
    for (const Vec2 uv : {a, b, c}) moved.push_back(uv - Vec2{u, v});
    triangle = {first, first + 1, first + 2};
  }
  mesh.uvs = std::move(moved);
}

/// The picture over the mesh's own texture coordinates; null where these leave the unit square.
std::shared_ptr<const Image> picture_over(const Glow& glow, std::span<const Vec2> uvs) {
  if (!are_within(uvs)) return nullptr;
  if (is_identity(glow.uv)) return glow.picture;
  return std::make_shared<const Image>(resampled(*glow.picture, glow.uv, glow.wrap));
}

}  // namespace

bool emits(const Glow& glow) {
  return !is_black(glow.radiance) && !(glow.picture && is_black(mean_of(*glow.picture)));
}

bool set_emission(const Glow& glow, Mesh& mesh, ScenePart& part) {
  part.radiance = glow.radiance;
  part.side = glow.side;
  if (!glow.picture) return true;
  if (glow.may_move_uvs) move_into_square(mesh);
  part.picture = picture_over(glow, mesh.uvs);
  if (!part.picture) part.radiance = glow.radiance * mean_of(*glow.picture);
  return part.picture != nullptr;
}

}  // namespace twinray
