// SPDX-License-Identifier: Apache-2.0
#include "core/scene_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/angle.h"
#include "core/error.h"
#include "core/texture_parts.h"

namespace twinray {
namespace {

/// Checks a texture, and counts what it is made of: itself, and all that it names, as often as it does.
struct Check {
  std::span<const Texture> textures;
  std::size_t index;
  const std::vector<std::uint64_t>& parts;  ///< Of the textures before it.

  std::uint64_t operator()(const auto& texture) const {
    std::uint64_t count = 1;
    for_each_part(texture, [&](std::uint32_t part) { count += of(part); });
    check(texture);
    return count;
  }

 private:
  std::uint64_t of(std::uint32_t other) const {
    if (other >= index)
      throw Error(fmt::format("texture {} names texture {}, which does not stand before it", index, other));
    return parts[other];
  }
  void check(const auto& /*texture*/) const {}
  void check(const ImageTexture& texture) const {
    if (!texture.image) throw Error(fmt::format("texture {} has no picture", index));
  }
  void check(const PlacedTexture& texture) const {
    if (!is_pattern(textures[texture.texture].model))
      throw Error(fmt::format("texture {} places texture {}, which is no pattern", index, texture.texture));
  }
  bool is_pattern(const TextureModel& model) const {
    if (std::holds_alternative<ImageTexture>(model) || std::holds_alternative<NoiseTexture>(model) ||
        std::holds_alternative<BilinearTexture>(model))
      return true;
    bool of_constants = std::holds_alternative<CheckerboardTexture>(model) ||
                        std::holds_alternative<DotsTexture>(model) ||
                        std::holds_alternative<CubesTexture>(model);
    for_each_part(model, [&](std::uint32_t part) {
      of_constants = of_constants && std::holds_alternative<ConstantTexture>(textures[part].model);
    });
    return of_constants;
  }
};

/// Whether a texture of its own may have values outside of [0, 1].
struct MayExceedUnit {
  bool operator()(const ConstantTexture& texture) const {
    return within_unit(texture.value) != texture.value;
  }
  bool operator()(const ImageTexture& texture) const { return !texture.image->is_within_unit(); }
  bool operator()(const NoiseTexture& texture) const { return texture.pattern != NoisePattern::marble; }
  bool operator()(const BilinearTexture&) const { return true; }  // Beyond its corners.
  bool operator()(const auto&) const { return false; }
};

/// Of each texture, whether it is a part of one whose values may lie outside of [0, 1], where materials cut
/// them off: what is left of the mean is more than the mean of what is left of single pixels.
std::vector<bool> cut_off(std::span<const Texture> textures) {
  std::vector<bool> is_cut(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    is_cut[i] = std::visit(MayExceedUnit{}, textures[i].model);
    for_each_part(textures[i].model, [&](std::uint32_t part) { is_cut[i] = is_cut[i] || is_cut[part]; });
  }
  for (std::size_t i = textures.size(); i-- > 0;)
    for_each_part(textures[i].model, [&](std::uint32_t part) { is_cut[part] = is_cut[part] || is_cut[i]; });
  return is_cut;
}

/// Whether a texture goes by the point in the scene, whatever it is made of.
struct GoesByPosition {
  template <typename Model>
  bool operator()(const Model&) const {
    return std::is_same_v<Model, CubesTexture> || std::is_same_v<Model, DirectionMixTexture> ||
           std::is_same_v<Model, NoiseTexture> || std::is_same_v<Model, PlacedTexture>;
  }
};

/// Whether a texture goes by the surface's coordinates, whatever it is made of.
struct GoesByCoordinates {
  bool operator()(const auto& texture) const {
    return requires { texture.uv; };
  }
};

struct MeanValue {
  std::span<const Rgb> means;

  Rgb operator()(const ConstantTexture& texture) const { return texture.value; }
  Rgb operator()(const ImageTexture& texture) const { return texture.image->mean(); }
  Rgb operator()(const ScaleTexture& texture) const { return means[texture.first] * means[texture.second]; }
  Rgb operator()(const MixTexture& texture) const { return mixed(texture, means[texture.amount].r); }
  Rgb operator()(const CheckerboardTexture& texture) const { return mixed(texture, 0.5f); }
  Rgb operator()(const CubesTexture& texture) const { return mixed(texture, 0.5f); }
  Rgb operator()(const DotsTexture& texture) const { return mixed(texture, 1 - part_in_dots); }
  Rgb operator()(const BilinearTexture& texture) const {
    return (texture.v00 + texture.v10 + texture.v01 + texture.v11) * 0.25f;
  }
  /// Of directions that are spread evenly.
  Rgb operator()(const DirectionMixTexture& texture) const { return mixed(texture, 0.5f); }
  Rgb operator()(const NoiseTexture& texture) const {
    switch (texture.pattern) {
      case NoisePattern::fbm:
      case NoisePattern::windy:
        break;
      case NoisePattern::wrinkled:
        return white * turbulence({}, 1, texture.octaves);
      case NoisePattern::marble: {
        constexpr int phases = 64;
        Rgb sum;
        for (int i = 0; i < phases; ++i) sum += marble_color(2 * pi * (float(i) + 0.5f) / phases);
        return sum * (1.0f / phases);
      }
    }
    return {};
  }
  Rgb operator()(const PlacedTexture& texture) const { return means[texture.texture]; }

 private:
  Rgb mixed(const auto& texture, float amount) const {
    return means[texture.first] * (1 - amount) + means[texture.second] * amount;
  }
};

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
    for_each_part(textures[i].model, [&](std::uint32_t other) { is_wanted[std::min(other, i)] = true; });
  }
}

bool has_picture(std::span<const Texture> textures) {
  return std::any_of(textures.begin(), textures.end(), [](const Texture& texture) {
    return std::holds_alternative<ImageTexture>(texture.model);
  });
}

bool goes_by_second_uvs(std::span<const Texture> textures, std::uint32_t index) {
  const TextureModel& model = textures[index].model;
  const auto* image = std::get_if<ImageTexture>(&model);
  bool found = image && image->coordinates == CoordinateSet::second;
  for_each_part(model, [&](std::uint32_t part) { found = found || goes_by_second_uvs(textures, part); });
  return found;
}

std::vector<bool> go_by_position(std::span<const Texture> textures) {
  std::vector<bool> found(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    found[i] = std::visit(GoesByPosition{}, textures[i].model);
    for_each_part(textures[i].model,
                  [&](std::uint32_t part) { found[i] = found[i] || (part < i && found[part]); });
  }
  return found;
}

bool goes_by_coordinates(const TextureModel& model, const std::vector<bool>& before) {
  const auto* placed = std::get_if<PlacedTexture>(&model);
  if (placed && placed->placement != TexturePlacement::space) return false;
  bool found = std::visit(GoesByCoordinates{}, model);
  for_each_part(model, [&](std::uint32_t part) { found = found || before[part]; });
  return found;
}

Rgb mean_value(const TextureModel& model, std::span<const Rgb> means) {
  return std::visit(MeanValue{means}, model);
}

void check_textures(std::span<const Texture> textures) {
  std::vector<std::uint64_t> parts;
  parts.reserve(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    parts.push_back(std::visit(Check{textures, i, parts}, textures[i].model));
    if (parts.back() > most_texture_parts)
      throw Error(fmt::format("texture {} is made of more than {} textures", i, most_texture_parts));
  }
}

}  // namespace twinray
