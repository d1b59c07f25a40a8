// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/scene_textures.h"
#include "io/affine_texture.h"
#include "io/decimal.h"
#include "io/pbrt/spectrum.h"
#include "io/pbrt/transform.h"
#include "io/pbrt/version_three.h"
#include "io/pbrt/word.h"
#include "io/picture/texture_file.h"

namespace twinray {
namespace {

constexpr std::array<std::string_view, 13> classes{
    "constant", "scale", "mix",    "directionmix", "imagemap", "checkerboard", "dots",
    "bilerp",   "fbm",   "marble", "windy",        "wrinkled", "ptex"};

constexpr std::array<PbrtWord<TextureFilter>, 5> filters{{{"bilinear", TextureFilter::bilinear},
                                                          {"trilinear", TextureFilter::trilinear},
                                                          {"EWA", TextureFilter::trilinear},
                                                          {"ewa", TextureFilter::trilinear},
                                                          {"point", TextureFilter::nearest}}};
constexpr std::array<PbrtWord<WrapMode>, 4> wraps{{{"repeat", WrapMode::repeat},
                                                   {"clamp", WrapMode::clamp},
                                                   {"black", WrapMode::black},
                                                   {"octahedralsphere", WrapMode::clamp}}};

enum class PbrtMapping { uv, planar, spherical, cylindrical };
constexpr std::array<PbrtWord<PbrtMapping>, 4> mappings{{{"uv", PbrtMapping::uv},
                                                         {"planar", PbrtMapping::planar},
                                                         {"spherical", PbrtMapping::spherical},
                                                         {"cylindrical", PbrtMapping::cylindrical}}};

constexpr std::array<PbrtWord<NoisePattern>, 4> patterns{{{"fbm", NoisePattern::fbm},
                                                          {"wrinkled", NoisePattern::wrinkled},
                                                          {"windy", NoisePattern::windy},
                                                          {"marble", NoisePattern::marble}}};

}  // namespace

void PbrtTextures::define(const std::string& name, const std::string& type,
                          const PbrtTextureStatement& statement) {
  const auto& [texture_class, parameters, to_world] = statement;
  if (type != "float" && type != "spectrum")
    parameters.place().fail(
        fmt::format("the texture \"{}\" is of type \"{}\"; valid are float and spectrum{}", name, type,
                    version_three_hint(type)));
  if (std::find(classes.begin(), classes.end(), texture_class) == classes.end())
    parameters.place().fail(
        fmt::format("there is no texture class \"{}\"; valid are {}", texture_class, list_names(classes)));
  const PictureChannels kind = type == "float" ? PictureChannels::number : PictureChannels::color;
  if (named_.count({name, kind}) > 0)
    parameters.place().warn(
        context_.warnings,
        fmt::format("the texture \"{}\" is defined a second time; the last one counts", name));
  const Named made = make(statement, kind);
  textures[made.index].name = name;
  named_[{name, kind}] = made;
  parameters.warn_of_unused(context_.warnings);
}

PbrtTextures::Named PbrtTextures::named(std::uint32_t index) {
  while (means_.size() < textures.size()) {
    const TextureModel& model = textures[means_.size()].model;
    means_.push_back(mean_value(model, means_));
    by_coordinates_.push_back(goes_by_coordinates(model, by_coordinates_));
  }
  return {index, means_[index]};
}

PbrtTextures::Named PbrtTextures::add(const TextureModel& model) {
  textures.push_back({"", model});
  return named(std::uint32_t(textures.size() - 1));
}

PbrtTextures::Named PbrtTextures::value(const PbrtParameters& parameters, const char* name, float fallback,
                                        PictureChannels kind) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return constant({fallback, fallback, fallback});
  if (found->type == PbrtType::texture) return named(parameters, *found, kind);
  return constant(color_of(parameters, *found, ColorRole::unbounded, context_.files));
}

std::uint32_t PbrtTextures::normal_map(const PbrtParameters& parameters) {
  const std::string name = parameters.text("normalmap", "");
  if (name.empty()) return no_texture;
  const PbrtPlace& place = parameters.find("normalmap")->place;
  LoadedTexture loaded =
      load_normal_map(context_.files.is_disk() ? context_.files.path(place, name) : "", context_.options);
  if (!loaded.warning.empty()) place.warn(context_.warnings, loaded.warning);
  ImageTexture picture{.image = loaded.image};
  picture.filter = TextureFilter::bilinear;
  return add(picture).index;
}

std::uint32_t PbrtTextures::bump_map(const PbrtParameters& parameters) {
  const PbrtParameter* found = parameters.find("displacement");
  if (!found) return no_texture;
  if (found->type == PbrtType::texture) return named(parameters, *found, PictureChannels::number).index;
  parameters.real("displacement", 0);
  return no_texture;
}

std::uint32_t PbrtTextures::alpha(const PbrtParameters& parameters) {
  const PbrtParameter* found = parameters.find("alpha");
  if (!found) return no_texture;
  if (found->type == PbrtType::texture) return named(parameters, *found, PictureChannels::number).index;
  const float alpha = parameters.real("alpha", 1);
  return alpha >= 1 ? no_texture : constant({alpha, alpha, alpha}).index;
}

std::uint32_t PbrtTextures::scaled(std::uint32_t texture, float scale) {
  return add(ScaleTexture{texture, constant({scale, scale, scale}).index}).index;
}

bool PbrtTextures::is_at_most(std::uint32_t texture, float number) const {
  const auto* constant = std::get_if<ConstantTexture>(&textures[texture].model);
  return constant && !(constant->value.r > number);
}

namespace {

/// From the scene to where a texture's patterns lie.
Transform from_world(const PbrtTextureStatement& statement) {
  const auto found = inverse(statement.to_world);
  if (!found)
    statement.parameters.place().fail("the transform here flattens space: no texture can be placed by it");
  return *found;
}

void set_row(PointTransform& map, int row, const Transform& from_world, const Vec3& axis, float shift) {
  for (int column = 0; column < 4; ++column) {
    double sum = column == 3 ? double(shift) : 0;
    for (int i = 0; i < 3; ++i) sum += double(axis[i]) * from_world.m[i][column];
    map.m[row][column] = float(sum);
  }
}

/// From the scene to coordinates along the axes, shifted.
PointTransform along_axes(const PbrtTextureStatement& statement, const std::array<Vec3, 3>& axes,
                          const Vec3& shift) {
  const Transform from_scene = from_world(statement);
  PointTransform map;
  bool is_finite = true;
  for (int row = 0; row < 3; ++row) {
    set_row(map, row, from_scene, axes[std::size_t(row)], shift[row]);
    for (const float number : map.m[row]) is_finite = is_finite && std::isfinite(number);
  }
  if (!is_finite)
    statement.parameters.place().fail("the coordinates of this texture are too large for single precision");
  return map;
}
constexpr std::array<Vec3, 3> own_axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

PbrtTextures::Mapping PbrtTextures::read_mapping(const PbrtTextureStatement& statement) {
  const PbrtParameters& parameters = statement.parameters;
  const auto mapping = word_of(parameters, "mapping", mappings);
  const auto shift = [&](const char* name) { return parameters.real(name, 0); };
  if (mapping == PbrtMapping::uv)
    return {{{{parameters.real("uscale", 1), 0, shift("udelta")},
              {0, parameters.real("vscale", 1), shift("vdelta")}}},
            {}};
  PlacedTexture place;
  if (mapping == PbrtMapping::planar) {
    const Vec3 v1 = parameters.point("v1", own_axes[0]), v2 = parameters.point("v2", own_axes[1]);
    place.placement = TexturePlacement::planar;
    place.to_texture = along_axes(statement, {v1, v2, own_axes[2]}, {shift("udelta"), shift("vdelta"), 0});
  } else {
    place.placement =
        mapping == PbrtMapping::spherical ? TexturePlacement::spherical : TexturePlacement::cylindrical;
    place.to_texture = along_axes(statement, own_axes, {});
  }
  return {{}, place};
}

std::optional<PlacedTexture> PbrtTextures::space_of(const PbrtTextureStatement& statement) {
  const PointTransform to_texture = along_axes(statement, own_axes, {});
  if (to_texture == PointTransform{}) return std::nullopt;
  return PlacedTexture{.to_texture = to_texture};
}

PbrtTextures::Named PbrtTextures::placed(const TextureModel& pattern,
                                         const std::optional<PlacedTexture>& place) {
  const Named made = add(pattern);
  if (!place) return made;
  PlacedTexture placed = *place;
  placed.texture = made.index;
  return add(placed);
}

template <typename Pattern>
PbrtTextures::Named PbrtTextures::placed_parts(Pattern pattern, const std::optional<PlacedTexture>& place) {
  if (!place) return add(pattern);
  const std::uint32_t first = pattern.first, second = pattern.second;
  pattern.first = constant({}).index;
  pattern.second = constant(white).index;
  return add(MixTexture{first, second, placed(pattern, place).index});
}

PbrtTextures::Named PbrtTextures::make(const PbrtTextureStatement& statement, PictureChannels channels) {
  const auto& [texture_class, parameters, to_world] = statement;
  if (texture_class == "constant") return value(parameters, "value", 1, channels);
  if (texture_class == "imagemap") return read_picture(statement, channels);
  if (texture_class == "scale") {
    const Named tex = value(parameters, "tex", 1, channels),
                scale = value(parameters, "scale", 1, PictureChannels::number);
    return add(ScaleTexture{tex.index, scale.index});
  }
  if (texture_class == "mix") {
    const Named first = value(parameters, "tex1", 0, channels),
                second = value(parameters, "tex2", 1, channels);
    return add(MixTexture{first.index, second.index,
                          value(parameters, "amount", 0.5f, PictureChannels::number).index});
  }
  if (texture_class == "directionmix") return mix_by_direction(statement, channels);
  if (texture_class == "checkerboard") return checkerboard(statement, channels);
  if (texture_class == "dots") {
    const Named inside = value(parameters, "inside", 1, channels),
                outside = value(parameters, "outside", 0, channels);
    const Mapping mapping = read_mapping(statement);
    // As in pbrt's pictures, where the dots are what is called outside.
    return placed_parts(DotsTexture{outside.index, inside.index, mapping.uv}, mapping.by_points);
  }
  if (texture_class == "bilerp") return corners(statement, channels);
  if (texture_class == "ptex") {
    for (const char* known : {"filename", "encoding", "scale"}) parameters.find(known);
    parameters.place().warn(context_.warnings, "a picture by faces is not rendered: 0.5 stands for it");
    return constant({0.5f, 0.5f, 0.5f});
  }
  return noise(statement, channels);
}

PbrtTextures::Named PbrtTextures::mix_by_direction(const PbrtTextureStatement& statement,
                                                   PictureChannels channels) {
  const PbrtParameters& parameters = statement.parameters;
  const Named first = value(parameters, "tex1", 0, channels), second = value(parameters, "tex2", 1, channels);
  const Vec3 direction = statement.to_world.vector(parameters.point("dir", {0, 1, 0}));
  const float along = length(direction);
  if (!(along > 0 && std::isfinite(along)))
    parameters.place().fail("the \"dir\" of a directionmix is no direction here");
  return add(DirectionMixTexture{first.index, second.index, direction / along});
}

PbrtTextures::Named PbrtTextures::checkerboard(const PbrtTextureStatement& statement,
                                               PictureChannels channels) {
  const PbrtParameters& parameters = statement.parameters;
  const std::uint32_t first = value(parameters, "tex1", 1, channels).index,
                      second = value(parameters, "tex2", 0, channels).index;
  if (parameters.integer("dimension", 2, {2, 3}) == 3)
    return placed_parts(CubesTexture{first, second}, space_of(statement));
  const Mapping mapping = read_mapping(statement);
  return placed_parts(CheckerboardTexture{first, second, mapping.uv}, mapping.by_points);
}

PbrtTextures::Named PbrtTextures::corners(const PbrtTextureStatement& statement, PictureChannels channels) {
  const auto corner = [&](const char* name, float usual) {
    return value(statement.parameters, name, usual, channels).mean;
  };
  const Mapping mapping = read_mapping(statement);
  return placed(BilinearTexture{.v00 = corner("v00", 0),
                                .v10 = corner("v10", 0),
                                .v01 = corner("v01", 1),
                                .v11 = corner("v11", 1),
                                .uv = mapping.uv},
                mapping.by_points);
}

PbrtTextures::Named PbrtTextures::noise(const PbrtTextureStatement& statement, PictureChannels channels) {
  const auto& [texture_class, parameters, to_world] = statement;
  NoiseTexture made;
  for (const auto& [word, pattern] : patterns)
    if (word == texture_class) made.pattern = pattern;
  const bool is_marble = made.pattern == NoisePattern::marble;
  if (is_marble != (channels == PictureChannels::color))
    parameters.place().warn(context_.warnings,
                            fmt::format("{} is a texture of type {} in pbrt, which fails here", texture_class,
                                        is_marble ? "spectrum" : "float"));
  if (made.pattern != NoisePattern::windy)
    made.octaves = {parameters.integer("octaves", 8, {0, 64}), parameters.real("roughness", 0.5f)};
  if (is_marble) {
    made.scale = parameters.real("scale", 1);
    made.variation = parameters.real("variation", 0.2f);
  }
  return placed(made, space_of(statement));
}

PictureRole PbrtTextures::role_of(const PbrtParameters& parameters) {
  const std::string encoding = parameters.text("encoding", "sRGB");
  if (encoding == "sRGB") return PictureRole::color;
  if (encoding == "linear") return PictureRole::data;
  constexpr std::string_view gamma = "gamma ";
  const PbrtPlace& place = parameters.find("encoding")->place;
  const auto exponent = read_decimal<float>(
      encoding.starts_with(gamma) ? std::string_view(encoding).substr(gamma.size()) : std::string_view());
  if (exponent.fault != DecimalFault::none)
    place.fail(fmt::format("there is no encoding \"{}\"; valid are sRGB, linear and \"gamma X\"", encoding));
  if (exponent.value == 1) return PictureRole::data;
  place.warn(context_.warnings, fmt::format("\"{}\" is not rendered; it is sRGB", encoding));
  return PictureRole::color;
}

PbrtTextures::Named PbrtTextures::read_picture(const PbrtTextureStatement& statement,
                                               PictureChannels channels) {
  const PbrtParameters& parameters = statement.parameters;
  const Mapping mapping = read_mapping(statement);
  ImageTexture picture;
  picture.uv = mapping.uv;
  picture.filter = word_of(parameters, "filter", filters);
  picture.wrap = word_of(parameters, "wrap", wraps);
  if (parameters.text("wrap", "") == "octahedralsphere")
    parameters.find("wrap")->place.warn(context_.warnings,
                                        "\"octahedralsphere\" is not rendered; it is clamp");
  parameters.find("maxanisotropy");
  const std::string name = parameters.text("filename", "");
  if (name.empty()) parameters.place().fail("an imagemap needs its picture, \"string filename\"");
  const PbrtPlace& place = parameters.find("filename")->place;
  const PictureRole role = role_of(parameters);
  const std::string path = context_.files.is_disk() ? context_.files.path(place, name) : "";
  LoadedTexture loaded = load_texture(path, {role, channels}, context_.options);
  if (!loaded.warning.empty()) place.warn(context_.warnings, loaded.warning);
  picture.image = loaded.image;
  const Named read = placed(picture, mapping.by_points);
  const float scale = parameters.real("scale", 1);
  const Named result = scale == 1 ? read : named(scaled(read.index, scale));
  return parameters.flag("invert", false) ? inverted(result) : result;
}

PbrtTextures::Named PbrtTextures::inverted(const Named& from) {
  return named(add_affine(textures, from.index, white * -1, white));
}

const PbrtTextures::Named& PbrtTextures::named(const PbrtParameters& parameters,
                                               const PbrtParameter& parameter, PictureChannels kind) const {
  const std::string name = parameters.text(parameter);
  if (const auto found = named_.find({name, kind}); found != named_.end()) return found->second;
  const bool is_number = kind == PictureChannels::number;
  const auto other = named_.find({name, is_number ? PictureChannels::color : PictureChannels::number});
  if (other != named_.end()) {
    constexpr const char *number = "float", *color = "spectrum";
    parameter.place.warn(
        context_.warnings,
        fmt::format("\"{}\" needs a texture of type {}, and \"{}\" is one of type {}: {}, where pbrt fails",
                    parameter.name, is_number ? number : color, name, is_number ? color : number,
                    is_number ? "its red stands for the number" : "it is taken as grey"));
    return other->second;
  }
  parameter.place.fail(fmt::format("no texture \"{}\" is defined before this", name));
}

}  // namespace twinray
