// SPDX-License-Identifier: Apache-2.0
#include "core/texture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/elementary.h"
#include "core/texture_parts.h"
#include "core/texture_pattern.h"
#include "core/texture_placement.h"

namespace twinray {
namespace {

/// Numbers beyond which conversions to int are not used.
constexpr double most_int = 0x1p30;

/// The greatest whole number that is not above x: std::floor, which is a call where the machine is any of
/// x86-64.
double floor_of(double x) {
  if (!(std::fabs(x) < most_int)) return std::floor(x);
  const int toward_zero = int(x);
  return toward_zero > x ? toward_zero - 1 : toward_zero;
}

/// The column or row, of so many, that stands where there may be none: a whole number of any size, for
/// coordinates may be large. None where nothing stands there.
std::optional<int> wrapped(double place, int count, WrapMode wrap) {
  if (wrap == WrapMode::repeat) {
    if (std::fabs(place) < most_int) {
      const int past = int(place) % count;
      return past < 0 ? past + count : past;
    }
    place -= count * std::floor(place / count);
  }
  if (wrap == WrapMode::black && !(place >= 0 && place < count)) return {};
  return int(std::clamp(place, 0.0, double(count - 1)));
}

/// A pixel of a level.
struct Texel {
  MipLevel level;
  int column, row;

  Rgb value() const { return level.at(column, row); }
};

/// The one at a position; none where nothing stands there.
std::optional<Texel> texel_at(const MipLevel& level, Wrap wrap, double x, double y) {
  const auto column = wrapped(x, level.width, wrap.u), row = wrapped(y, level.height, wrap.v);
  if (!(column && row)) return {};
  return Texel{level, *column, *row};
}

Rgb value_of(const std::optional<Texel>& texel) { return texel ? texel->value() : Rgb{}; }

}  // namespace

Rgb bilinear(const MipLevel& image, Wrap wrap, Vec2 uv) {
  if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
  const double column = double(uv.x) * image.width - 0.5, row = (1 - double(uv.y)) * image.height - 0.5;
  const double left = floor_of(column), above = floor_of(row);
  const auto s = float(column - left), t = float(row - above);
  const auto at = [&](int dx, int dy) { return value_of(texel_at(image, wrap, left + dx, above + dy)); };
  const Rgb upper = at(0, 0) * (1 - s) + at(1, 0) * s;
  const Rgb lower = at(0, 1) * (1 - s) + at(1, 1) * s;
  return upper * (1 - t) + lower * t;
}

namespace {

std::optional<Texel> nearest_texel(const MipLevel& image, Wrap wrap, Vec2 uv) {
  return texel_at(image, wrap, floor_of(double(uv.x) * image.width),
                  floor_of((1 - double(uv.y)) * image.height));
}

}  // namespace

Rgb nearest(const MipLevel& image, Wrap wrap, Vec2 uv) {
  if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
  return value_of(nearest_texel(image, wrap, uv));
}

namespace {

/// What is left of a draw in [0, 1) once it has chosen one of two: the second with the given probability.
struct ChoiceOfTwo {
  bool second;
  float draw;  ///< Uniform again.
};
ChoiceOfTwo choose(float probability, float draw) {
  if (draw < probability) return {true, draw / probability};
  return {false, (draw - probability) / (1 - probability)};
}

/// One of the pixels that bilinear would mix, each with the probability that is its part there.
std::optional<Texel> stochastic_texel(const MipLevel& image, Wrap wrap, Vec2 uv, Vec2 draw) {
  const double column = double(uv.x) * image.width - 0.5, row = (1 - double(uv.y)) * image.height - 0.5;
  const double left = floor_of(column), above = floor_of(row);
  const bool is_right = draw.x < float(column - left), is_below = draw.y < float(row - above);
  return texel_at(image, wrap, left + is_right, above + is_below);
}

/// How much a transform stretches at most, about: the larger of its columns' lengths.
float stretch(const UvTransform& uv) {
  const auto& m = uv.m;
  return std::sqrt(std::max(m[0][0] * m[0][0] + m[1][0] * m[1][0], m[0][1] * m[0][1] + m[1][1] * m[1][1]));
}

/// The level whose pixels are as wide as the footprint, in [0, levels - 1].
float level_of(const MipMap& image, float footprint) {
  const MipLevel picture = image.level(0);
  const float pixels = footprint * float(std::max(picture.width, picture.height));
  if (!(pixels > 1)) return 0;
  const auto coarsest = float(image.levels() - 1);
  return pixels < 0x1p30f ? std::min(short_log2_of(pixels), coarsest) : coarsest;
}

/// Where a picture is looked up.
struct ImagePlace {
  Vec2 uv;
  int finer = 0;  ///< The level, and how far it is to the next one.
  float t = 0;
};

bool has_levels(TextureFilter filter) {
  return filter == TextureFilter::trilinear || filter == TextureFilter::stochastic;
}

bool is_second(const ImageTexture& texture) { return texture.coordinates == CoordinateSet::second; }

/// In the picture's own coordinates, in which it is 1 wide and high.
float footprint_in(const ImageTexture& texture, const TexturePoint& at) {
  return (is_second(texture) ? at.second_footprint : at.footprint) * stretch(texture.uv);
}

ImagePlace place_of(const ImageTexture& texture, const TexturePoint& at) {
  ImagePlace place{texture.uv(is_second(texture) ? at.second_uv : at.uv)};
  if (!has_levels(texture.filter)) return place;
  const float level = level_of(*texture.image, footprint_in(texture, at));
  place.finer = int(level);
  place.t = level - float(place.finer);
  return place;
}

/// The one pixel that the texture's value is there, of filters that take one; uv finite.
std::optional<Texel> single_texel(const ImageTexture& texture, const ImagePlace& place, Vec2 draw) {
  if (texture.filter == TextureFilter::nearest)
    return nearest_texel(texture.image->level(0), texture.wrap, place.uv);
  const ChoiceOfTwo coarser = choose(place.t, draw.x);
  return stochastic_texel(texture.image->level(place.finer + coarser.second), texture.wrap, place.uv,
                          {coarser.draw, draw.y});
}

bool takes_one(const ImageTexture& texture, const TexturePoint& at) {
  return texture.filter == TextureFilter::nearest ||
         (texture.filter == TextureFilter::stochastic && !at.is_smooth);
}

struct Evaluate {
  std::span<const Texture> textures;
  const TexturePoint& at;

  Rgb of(std::uint32_t index) const { return evaluate(textures, index, at); }

  Rgb operator()(const ConstantTexture& texture) const { return texture.value; }
  Rgb operator()(const ScaleTexture& texture) const { return of(texture.first) * of(texture.second); }
  Rgb operator()(const MixTexture& texture) const {
    const float amount = of(texture.amount).r;
    return of(texture.first) * (1 - amount) + of(texture.second) * amount;
  }
  Rgb operator()(const CheckerboardTexture& texture) const {
    return of(shows_first(texture, at) ? texture.first : texture.second);
  }
  Rgb operator()(const CubesTexture& texture) const {
    return of(shows_first(texture, at) ? texture.first : texture.second);
  }
  Rgb operator()(const DotsTexture& texture) const {
    return of(shows_first(texture, at) ? texture.first : texture.second);
  }
  Rgb operator()(const BilinearTexture& texture) const { return value_of_pattern(texture, at); }
  Rgb operator()(const NoiseTexture& texture) const { return value_of_pattern(texture, at); }
  Rgb operator()(const DirectionMixTexture& texture) const {
    const float amount = std::min(std::fabs(dot(at.normal, texture.direction)), 1.0f);
    return of(texture.first) * amount + of(texture.second) * (1 - amount);
  }
  Rgb operator()(const PlacedTexture& texture) const {
    return evaluate(textures, texture.texture, placed_point(texture, at));
  }
  Rgb operator()(const ImageTexture& texture) const {
    const ImagePlace place = place_of(texture, at);
    const Vec2 uv = place.uv;
    if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
    if (takes_one(texture, at)) return value_of(single_texel(texture, place, at.draw));
    const Rgb fine = bilinear(texture.image->level(place.finer), texture.wrap, uv);
    if (place.t == 0) return fine;
    return fine * (1 - place.t) + bilinear(texture.image->level(place.finer + 1), texture.wrap, uv) * place.t;
  }
};

/// Asks memory for what evaluate() is going to read.
struct Prefetch {
  std::span<const Texture> textures;
  const TexturePoint& at;

  void of(std::uint32_t index) const { prefetch_texels(textures, index, at); }
  void operator()(const ImageTexture& texture) const {
    if (is_near(texture)) return;
    const ImagePlace place = place_of(texture, at);
    if (!(std::isfinite(place.uv.x) && std::isfinite(place.uv.y))) return;
    if (takes_one(texture, at)) return prefetch(single_texel(texture, place, at.draw));
    // The middles of the two rows of four pixels; the coarser level has a quarter of the pixels.
    const MipLevel level = texture.image->level(place.finer);
    for (const float row : {-0.5f, 0.5f})
      prefetch(nearest_texel(level, texture.wrap, {place.uv.x, place.uv.y + row / float(level.height)}));
  }
  void operator()(const PlacedTexture& texture) const {
    prefetch_texels(textures, texture.texture, placed_point(texture, at));
  }
  template <typename Model>
  void operator()(const Model& texture) const {
    for_each_part(texture, [&](std::uint32_t part) { of(part); });
  }

 private:
  /// Whether the level is so small that it stays in the second cache, with others.
  bool is_near(const ImageTexture& texture) const {
    constexpr int few = 256;  // On a side, of 12 bytes each.
    const MipLevel picture = texture.image->level(0);
    if (std::max(picture.width, picture.height) <= few) return true;
    return has_levels(texture.filter) && footprint_in(texture, at) * few > 1;
  }
  static void prefetch(const std::optional<Texel>& texel) {
    if (texel) texel->level.prefetch(texel->column, texel->row);
  }
};

}  // namespace

Rgb evaluate(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at) {
  return std::visit(Evaluate{textures, at}, textures[index].model);
}

void prefetch_texels(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at) {
  std::visit(Prefetch{textures, at}, textures[index].model);
}

}  // namespace twinray
