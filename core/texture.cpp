// SPDX-License-Identifier: Apache-2.0
#include "core/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/elementary.h"
#include "core/error.h"

namespace twinray {
namespace {

/// The column or row, of so many, that stands where there may be none: a whole number of any size, for
/// coordinates may be large. None where nothing stands there.
std::optional<int> wrapped(double place, int count, WrapMode wrap) {
  if (wrap == WrapMode::repeat) place -= count * std::floor(place / count);
  if (wrap == WrapMode::black && !(place >= 0 && place < count)) return {};
  return int(std::clamp(place, 0.0, double(count - 1)));
}

/// The pixel at a position.
Rgb wrapped(const MipLevel& image, Wrap wrap, double x, double y) {
  const auto column = wrapped(x, image.width, wrap.u), row = wrapped(y, image.height, wrap.v);
  return column && row ? image.at(*column, *row) : Rgb{};
}

}  // namespace

Rgb bilinear(const MipLevel& image, Wrap wrap, Vec2 uv) {
  if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
  const double column = double(uv.x) * image.width - 0.5, row = (1 - double(uv.y)) * image.height - 0.5;
  const double left = std::floor(column), above = std::floor(row);
  const auto s = float(column - left), t = float(row - above);
  const auto at = [&](int dx, int dy) { return wrapped(image, wrap, left + dx, above + dy); };
  const Rgb upper = at(0, 0) * (1 - s) + at(1, 0) * s;
  const Rgb lower = at(0, 1) * (1 - s) + at(1, 1) * s;
  return upper * (1 - t) + lower * t;
}

Rgb nearest(const MipLevel& image, Wrap wrap, Vec2 uv) {
  if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
  return wrapped(image, wrap, std::floor(double(uv.x) * image.width),
                 std::floor((1 - double(uv.y)) * image.height));
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
Rgb stochastic(const MipLevel& image, Wrap wrap, Vec2 uv, Vec2 draw) {
  const double column = double(uv.x) * image.width - 0.5, row = (1 - double(uv.y)) * image.height - 0.5;
  const double left = std::floor(column), above = std::floor(row);
  const bool is_right = draw.x < float(column - left), is_below = draw.y < float(row - above);
  return wrapped(image, wrap, left + is_right, above + is_below);
}

/// How much a transform stretches at most, about: the larger of its columns' lengths.
float stretch(const UvTransform& uv) {
  const auto& m = uv.m;
  return std::sqrt(std::max(m[0][0] * m[0][0] + m[1][0] * m[1][0], m[0][1] * m[0][1] + m[1][1] * m[1][1]));
}

/// The level whose pixels are as wide as the footprint, in [0, levels - 1].
double level_of(const MipMap& image, float footprint) {
  const MipLevel picture = image.level(0);
  const double pixels = double(footprint) * std::max(picture.width, picture.height);
  if (!(pixels > 1)) return 0;
  const double coarsest = image.levels() - 1;
  return pixels < 0x1p30 ? std::min(log2_of(pixels), coarsest) : coarsest;
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
    const Vec2 uv = texture.uv(at.uv);
    const double sum = std::floor(double(uv.x)) + std::floor(double(uv.y));
    return of(sum == 2 * std::floor(sum / 2) ? texture.first : texture.second);
  }
  Rgb operator()(const ImageTexture& texture) const {
    const Vec2 uv = texture.uv(at.uv);
    if (!(std::isfinite(uv.x) && std::isfinite(uv.y))) return {};
    const MipLevel picture = texture.image->level(0);
    if (texture.filter == TextureFilter::nearest) return nearest(picture, texture.wrap, uv);
    if (texture.filter == TextureFilter::bilinear) return bilinear(picture, texture.wrap, uv);
    const double level = level_of(*texture.image, at.footprint * stretch(texture.uv));
    const int finer = int(level);
    const auto t = float(level - finer);
    if (texture.filter == TextureFilter::stochastic && !at.is_smooth) {
      const ChoiceOfTwo coarser = choose(t, at.draw.x);
      return stochastic(texture.image->level(finer + coarser.second), texture.wrap, uv,
                        {coarser.draw, at.draw.y});
    }
    const Rgb fine = bilinear(texture.image->level(finer), texture.wrap, uv);
    if (t == 0) return fine;
    return fine * (1 - t) + bilinear(texture.image->level(finer + 1), texture.wrap, uv) * t;
  }
};

/// Calls of(index) for each texture that one names.
template <typename Of>
struct ForEachNamed {
  const Of& of;

  void operator()(const ConstantTexture&) const {}
  void operator()(const ImageTexture&) const {}
  void operator()(const ScaleTexture& texture) const { of(texture.first), of(texture.second); }
  void operator()(const MixTexture& texture) const {
    of(texture.first), of(texture.second), of(texture.amount);
  }
  void operator()(const CheckerboardTexture& texture) const { of(texture.first), of(texture.second); }
};

/// Checks a texture, and counts what it is made of: itself, and all that it names, as often as it does.
struct Check {
  std::size_t index;
  const std::vector<std::uint64_t>& parts;  ///< Of the textures before it.

  std::uint64_t of(std::uint32_t other) const {
    if (other >= index)
      throw Error(fmt::format("texture {} names texture {}, which does not stand before it", index, other));
    return parts[other];
  }
  std::uint64_t operator()(const ConstantTexture&) const { return 1; }
  std::uint64_t operator()(const ImageTexture& texture) const {
    if (!texture.image) throw Error(fmt::format("texture {} has no picture", index));
    return 1;
  }
  std::uint64_t operator()(const ScaleTexture& texture) const {
    return 1 + of(texture.first) + of(texture.second);
  }
  std::uint64_t operator()(const MixTexture& texture) const {
    return 1 + of(texture.first) + of(texture.second) + of(texture.amount);
  }
  std::uint64_t operator()(const CheckerboardTexture& texture) const {
    return 1 + of(texture.first) + of(texture.second);
  }
};

/// Of each texture, whether it is a part of one whose values may lie outside of [0, 1], where materials cut
/// them off: what is left of the mean is more than the mean of what is left of single pixels.
std::vector<bool> cut_off(std::span<const Texture> textures) {
  std::vector<bool> is_cut(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (const auto* constant = std::get_if<ConstantTexture>(&textures[i].model))
      is_cut[i] = within_unit(constant->value) != constant->value;
    if (const auto* image = std::get_if<ImageTexture>(&textures[i].model))
      is_cut[i] = !image->image->is_within_unit();
    const auto of = [&](std::uint32_t part) { is_cut[i] = is_cut[i] || is_cut[part]; };
    std::visit(ForEachNamed<decltype(of)>{of}, textures[i].model);
  }
  for (std::size_t i = textures.size(); i-- > 0;) {
    const auto of = [&](std::uint32_t part) { is_cut[part] = is_cut[part] || is_cut[i]; };
    std::visit(ForEachNamed<decltype(of)>{of}, textures[i].model);
  }
  return is_cut;
}

}  // namespace

void set_filter(std::span<Texture> textures, TextureFilter filter) {
  const std::vector<bool> is_cut = cut_off(textures);
  // Whoever asks for pixels wants to see them; and a picture that vertices were drawn into
  // is exact as it is: pixels by chance would add noise to it.
  const auto is_meant = [](const ImageTexture& image) {
    const MipLevel picture = image.image->level(0);
    const bool has_levels = image.image->levels() > 1 || picture.width * picture.height == 1;
    return image.filter == TextureFilter::nearest || (image.filter == TextureFilter::bilinear && !has_levels);
  };
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (auto* image = std::get_if<ImageTexture>(&textures[i].model); image && !is_meant(*image))
      image->filter = filter == TextureFilter::stochastic && is_cut[i] ? TextureFilter::trilinear : filter;
}

void keep_in_memory(std::span<Texture> textures, std::uint32_t index) {
  std::vector<bool> is_wanted(index + 1);
  is_wanted[index] = true;
  for (std::uint32_t i = index + 1; i-- > 0;) {  // A texture is made of some that stand before it.
    if (!is_wanted[i]) continue;
    if (auto* image = std::get_if<ImageTexture>(&textures[i].model)) image->image = in_memory(image->image);
    const auto of = [&](std::uint32_t other) { is_wanted[std::min(other, i)] = true; };
    std::visit(ForEachNamed<decltype(of)>{of}, textures[i].model);
  }
}

Rgb evaluate(std::span<const Texture> textures, std::uint32_t index, const TexturePoint& at) {
  return std::visit(Evaluate{textures, at}, textures[index].model);
}

bool has_picture(std::span<const Texture> textures) {
  return std::any_of(textures.begin(), textures.end(), [](const Texture& texture) {
    return std::holds_alternative<ImageTexture>(texture.model);
  });
}

void check_textures(std::span<const Texture> textures) {
  std::vector<std::uint64_t> parts;
  parts.reserve(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    parts.push_back(std::visit(Check{i, parts}, textures[i].model));
    if (parts.back() > most_texture_parts)
      throw Error(fmt::format("texture {} is made of more than {} textures", i, most_texture_parts));
  }
}

}  // namespace twinray
