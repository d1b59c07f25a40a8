// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/writer_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "core/scene_textures.h"
#include "io/pbrt/text.h"
#include "io/pbrt/transform.h"
#include "io/picture/baked_texture.h"
#include "io/picture/image_file.h"
#include "io/vertex_colors.h"

namespace twinray {
namespace {

const char* type_name(PbrtTextureKind kind) { return kind == PbrtTextureKind::color ? "spectrum" : "float"; }

/// What a stochastic filter gives on the average is trilinear.
const char* filter_name(TextureFilter filter) {
  if (filter == TextureFilter::nearest) return "point";
  return filter == TextureFilter::bilinear ? "bilinear" : "trilinear";
}

/// Red in all channels: pbrt takes a number of a picture as the mean of these.
Image red_of(Image image) {
  for (Rgb& pixel : image.pixels) pixel = {pixel.r, pixel.r, pixel.r};
  return image;
}

/// Whether a texture is of a kind that has no colours in pbrt.
bool is_number(std::span<const Texture> textures, std::uint32_t index) {
  if (const auto* mapped = std::get_if<PlacedTexture>(&textures[index].model))
    return is_number(textures, mapped->texture);
  const auto* noise = std::get_if<NoiseTexture>(&textures[index].model);
  return noise && noise->pattern != NoisePattern::marble;
}

const ConstantTexture* constant_of(std::span<const Texture> textures, std::uint32_t index) {
  return std::get_if<ConstantTexture>(&textures[index].model);
}

}  // namespace

std::string PbrtTextureWriter::define(const std::string& name, const std::string& type,
                                      const std::string& rest) {
  text += fmt::format("Texture {} \"{}\" {}\n", pbrt_string(name), type, rest);
  return name;
}

std::string PbrtTextureWriter::named(std::uint32_t texture, PbrtTextureKind kind) {
  const auto known = named_.find({texture, kind});
  if (known != named_.end()) return known->second;
  const auto unique_name = [&] {
    return names_.unique(textures[texture].name, fmt::format("texture {}", texture));
  };
  if (kind == PbrtTextureKind::color && is_number(textures, texture)) {
    const std::string grey = "\"mix\"" + pbrt_rgb("tex1", {}) + pbrt_rgb("tex2", white) +
                             pbrt_texture("amount", named(texture, PbrtTextureKind::number));
    return named_[{texture, kind}] = define(unique_name(), type_name(kind), grey);
  }
  if (const auto* found = std::get_if<PlacedTexture>(&textures[texture].model)) {
    const PlacedTexture placed = *found;
    return named_[{texture, kind}] = define_placed(unique_name(), placed, kind);
  }
  const std::string rest = rest_of(texture, kind);  // First, for it may define what it is made of.
  return named_[{texture, kind}] = define(unique_name(), type_name(kind), rest);
}

std::uint32_t PbrtTextureWriter::scaled(std::uint32_t texture, float factor) {
  if (factor == 1) return texture;
  textures.push_back({"", ConstantTexture{white * factor}});
  textures.push_back({"", ScaleTexture{texture, std::uint32_t(textures.size() - 1)}});
  return std::uint32_t(textures.size() - 1);
}

std::string PbrtTextureWriter::squared(std::uint32_t texture, float factor) {
  textures.push_back({"", ScaleTexture{texture, texture}});
  return named(scaled(std::uint32_t(textures.size() - 1), factor), PbrtTextureKind::number);
}

std::string PbrtTextureWriter::normal_map(std::uint32_t texture) {
  const auto known = normal_maps_.find(texture);
  if (known != normal_maps_.end()) return known->second;
  BakedTexture baked = bake(textures, texture);
  if (!baked.is_exact || baked.uv != UvTransform{} || baked.wrap != WrapMode::repeat)
    output_.losses.add("a normal map is written over the texture coordinates as they stand, and repeats",
                       "{} normal maps are written over the texture coordinates as they stand, and repeat");
  return normal_maps_[texture] = add_file(std::move(baked.picture));
}

std::string PbrtTextureWriter::part(const char* name, std::uint32_t texture, PbrtTextureKind kind) {
  const ConstantTexture* constant = constant_of(textures, texture);
  if (!constant) return pbrt_texture(name, named(texture, kind));
  return kind == PbrtTextureKind::color ? pbrt_rgb(name, constant->value)
                                        : pbrt_real(name, constant->value.r);
}

std::string PbrtTextureWriter::add_file(Image image) {
  const auto kept = std::make_shared<const Image>(std::move(image));
  return output_.add(fmt::format("-pbrt-texture-{}.exr", files_++),
                     [kept](const std::string& path) { write_exr(path, *kept); });
}

std::string PbrtTextureWriter::picture(const MipMap& image, PbrtTextureKind kind) {
  const auto [entry, is_new] = pictures_.try_emplace({&image, kind});
  if (!is_new) return entry->second;
  return entry->second = add_file(kind == PbrtTextureKind::color ? image.image(0) : red_of(image.image(0)));
}

std::string PbrtTextureWriter::wrap(const Wrap& wrap) {
  if (wrap.u != wrap.v)
    output_.losses.add("a picture that goes on otherwise along v than along u does so along both as along u",
                       "{} pictures that go on otherwise along v than along u do so along both as along u");
  constexpr const char* names[] = {"repeat", "clamp", "black"};
  return pbrt_word("wrap", names[int(wrap.u)]);
}

std::string PbrtTextureWriter::mapping(const UvTransform& uv) {
  const auto& [u, v] = uv.m;
  if (u[1] != 0 || v[0] != 0)
    output_.losses.add("a texture that is turned lies as if it were not",
                       "{} textures that are turned lie as if they were not");
  std::string numbers;
  for (const auto& [name, value, usual] : {std::tuple{"uscale", u[0], 1.0f},
                                           {"vscale", v[1], 1.0f},
                                           {"udelta", u[2], 0.0f},
                                           {"vdelta", v[2], 0.0f}})
    if (value != usual) numbers += pbrt_real(name, value);
  return numbers;
}

std::string PbrtTextureWriter::image_rest(const ImageTexture& texture, PbrtTextureKind kind) {
  if (texture.of_vertices)
    output_.losses.add("the colors of vertices are a picture, which is filtered across triangles",
                       "{} pictures are the colors of vertices, and are filtered across triangles");
  return "\"imagemap\"" + pbrt_word("filename", picture(*texture.image, kind)) +
         pbrt_word("filter", filter_name(texture.filter)) + wrap(texture.wrap) + mapping(texture.uv);
}

std::string PbrtTextureWriter::baked_rest(std::uint32_t texture, PbrtTextureKind kind) {
  BakedTexture baked = bake(textures, texture);
  if (!baked.is_exact)
    output_.losses.add(
        "a product of textures that lie differently, or by points, is a picture over the unit square",
        "{} products of textures that lie differently, or by points, are pictures over the unit square");
  if (kind == PbrtTextureKind::number) baked.picture = red_of(std::move(baked.picture));
  return "\"imagemap\"" + pbrt_word("filename", add_file(std::move(baked.picture))) +
         pbrt_word("filter", filter_name(baked.filter)) + wrap(baked.wrap) + mapping(baked.uv);
}

/// A colour there is times a number alone: of two textures with colours a picture is made.
std::string PbrtTextureWriter::scale_rest(std::uint32_t index, const ScaleTexture& texture,
                                          PbrtTextureKind kind) {
  std::uint32_t first = texture.first, second = texture.second;
  const auto is_number = [&](std::uint32_t t) {
    const ConstantTexture* constant = constant_of(textures, t);
    return kind == PbrtTextureKind::number || (constant && is_grey(constant->value));
  };
  if (!is_number(second)) std::swap(first, second);
  if (!is_number(second)) return baked_rest(index, kind);
  return "\"scale\"" + part("tex", first, kind) + part("scale", second, PbrtTextureKind::number);
}

std::string PbrtTextureWriter::rest_of(std::uint32_t index, PbrtTextureKind kind) {
  const TextureModel model = textures[index].model;
  if (const auto* constant = std::get_if<ConstantTexture>(&model))
    return "\"constant\"" + (kind == PbrtTextureKind::color ? pbrt_rgb("value", constant->value)
                                                            : pbrt_real("value", constant->value.r));
  if (const auto* image = std::get_if<ImageTexture>(&model)) return image_rest(*image, kind);
  if (const auto* scale = std::get_if<ScaleTexture>(&model)) return scale_rest(index, *scale, kind);
  if (const auto* mix = std::get_if<MixTexture>(&model))
    return "\"mix\"" + part("tex1", mix->first, kind) + part("tex2", mix->second, kind) +
           part("amount", mix->amount, PbrtTextureKind::number);
  if (const auto* noise = std::get_if<NoiseTexture>(&model)) return noise_rest(*noise, kind);
  return std::visit(
      [&](const auto& pattern) -> std::string {
        if constexpr (requires { pattern_rest(pattern, kind); }) return pattern_rest(pattern, kind);
        return {};  // named() places what is placed.
      },
      model);
}

std::string PbrtTextureWriter::pattern_rest(const CheckerboardTexture& board, PbrtTextureKind kind) {
  return "\"checkerboard\"" + part("tex1", board.first, kind) + part("tex2", board.second, kind) +
         mapping(board.uv);
}

std::string PbrtTextureWriter::pattern_rest(const CubesTexture& cubes, PbrtTextureKind kind) {
  return "\"checkerboard\" \"integer dimension\" 3" + part("tex1", cubes.first, kind) +
         part("tex2", cubes.second, kind);
}

std::string PbrtTextureWriter::pattern_rest(const DotsTexture& dots, PbrtTextureKind kind) {
  return "\"dots\"" + part("outside", dots.first, kind) + part("inside", dots.second, kind) +
         mapping(dots.uv);
}

std::string PbrtTextureWriter::pattern_rest(const BilinearTexture& square, PbrtTextureKind kind) {
  const auto corner = [&](const char* name, const Rgb& value) {
    return kind == PbrtTextureKind::color ? pbrt_rgb(name, value) : pbrt_real(name, value.r);
  };
  return "\"bilerp\"" + corner("v00", square.v00) + corner("v10", square.v10) + corner("v01", square.v01) +
         corner("v11", square.v11) + mapping(square.uv);
}

std::string PbrtTextureWriter::pattern_rest(const DirectionMixTexture& mix, PbrtTextureKind kind) {
  return "\"directionmix\"" + part("tex1", mix.first, kind) + part("tex2", mix.second, kind) +
         pbrt_vector("dir", mix.direction);
}

std::string PbrtTextureWriter::noise_rest(const NoiseTexture& texture, PbrtTextureKind kind) {
  const bool is_marble = texture.pattern == NoisePattern::marble;
  if (is_marble && kind == PbrtTextureKind::number) {
    output_.losses.add("marble that gives a number is its mean", "{} textures of marble are their means");
    return "\"constant\"" + pbrt_real("value", mean_value(texture, {}).r);
  }
  constexpr const char* names[] = {"fbm", "wrinkled", "windy", "marble"};
  std::string rest = fmt::format("\"{}\"", names[int(texture.pattern)]);
  if (texture.pattern != NoisePattern::windy)
    rest += fmt::format(" \"integer octaves\" {}", texture.octaves.most) +
            pbrt_real("roughness", texture.octaves.roughness);
  if (is_marble) rest += pbrt_real("scale", texture.scale) + pbrt_real("variation", texture.variation);
  return rest;
}

std::string PbrtTextureWriter::planar(const PlacedTexture& texture, const UvTransform& uv) {
  std::string words;
  for (int i = 0; i < 2; ++i) {
    float row[4];
    for (int k = 0; k < 4; ++k)
      row[k] = uv.m[i][0] * texture.to_texture.m[0][k] + uv.m[i][1] * texture.to_texture.m[1][k] +
               (k == 3 ? uv.m[i][2] : 0);
    words += pbrt_vector(i == 0 ? "v1" : "v2", {row[0], row[1], row[2]}) +
             pbrt_real(i == 0 ? "udelta" : "vdelta", row[3]);
  }
  return words;
}

std::string PbrtTextureWriter::define_placed(const std::string& name, const PlacedTexture& texture,
                                             PbrtTextureKind kind) {
  TextureModel pattern = textures[texture.texture].model;
  UvTransform uv;
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.uv; }) uv = std::exchange(model.uv, {});
      },
      pattern);
  textures.push_back({"", pattern});
  const std::string rest = rest_of(std::uint32_t(textures.size() - 1), kind);
  if (texture.placement == TexturePlacement::planar)
    return define(name, type_name(kind), rest + pbrt_word("mapping", "planar") + planar(texture, uv));
  Transform to_texture;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      to_texture.m[row][column] = double(texture.to_texture.m[row][column]);
  const auto to_world = inverse(to_texture);
  if (!to_world || uv != UvTransform{})
    output_.losses.add("a texture that goes by points lies elsewhere",
                       "{} textures that go by points lie elsewhere");
  const bool is_round = texture.placement != TexturePlacement::space;
  const char* const word = texture.placement == TexturePlacement::spherical ? "spherical" : "cylindrical";
  text += "AttributeBegin\n" + pbrt_transform(to_world.value_or(Transform{}));
  define(name, type_name(kind), rest + (is_round ? pbrt_word("mapping", word) : ""));
  text += "AttributeEnd\n";
  return name;
}

}  // namespace twinray
