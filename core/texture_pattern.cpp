// SPDX-License-Identifier: Apache-2.0
#include "core/texture_pattern.h"

#include <cmath>

namespace twinray {
namespace {

/// Of a whole number.
bool is_even(double number) { return number == 2 * std::floor(number / 2); }

}  // namespace

[[gnu::noinline]] bool shows_first(const CheckerboardTexture& texture, const TexturePoint& at) {
  const Vec2 uv = texture.uv(at.uv);
  return is_even(std::floor(double(uv.x)) + std::floor(double(uv.y)));
}

[[gnu::noinline]] bool shows_first(const CubesTexture& /*texture*/, const TexturePoint& at) {
  const Vec3& p = at.position;
  return is_even(std::floor(double(p.x)) + std::floor(double(p.y)) + std::floor(double(p.z)));
}

[[gnu::noinline]] bool shows_first(const DotsTexture& texture, const TexturePoint& at) {
  return is_in_dot(texture.uv(at.uv));
}

[[gnu::noinline]] Rgb value_of_pattern(const BilinearTexture& texture, const TexturePoint& at) {
  const Vec2 uv = texture.uv(at.uv);
  return (texture.v00 * (1 - uv.x) + texture.v10 * uv.x) * (1 - uv.y) +
         (texture.v01 * (1 - uv.x) + texture.v11 * uv.x) * uv.y;
}

[[gnu::noinline]] Rgb value_of_pattern(const NoiseTexture& texture, const TexturePoint& at) {
  const Vec3& p = at.position;
  switch (texture.pattern) {
    case NoisePattern::fbm:
      return white * fbm(p, at.width, texture.octaves);
    case NoisePattern::wrinkled:
      return white * turbulence(p, at.width, texture.octaves);
    case NoisePattern::windy: {
      const float strength = std::fabs(fbm(p * 0.1f, at.width * 0.1f, {3}));
      return white * (strength * fbm(p, at.width, {6}));
    }
    case NoisePattern::marble:
      break;
  }
  const Vec3 scaled = p * texture.scale;
  const float bent = fbm(scaled, at.width * std::fabs(texture.scale), texture.octaves);
  return marble_color(scaled.y + texture.variation * bent);
}

}  // namespace twinray
