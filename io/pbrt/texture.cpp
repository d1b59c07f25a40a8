// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/angle.h"
#include "io/affine_texture.h"
#include "io/decimal.h"
#include "io/pbrt/spectrum.h"
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

Rgb lerp(const Rgb& a, const Rgb& b, const Rgb& amount) { return a + (b - a) * amount; }

}  // namespace

void PbrtTextures::define(const std::string& name, const std::string& type, const std::string& texture_class,
                          const PbrtParameters& parameters) {
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
  const Named made = make(texture_class, parameters, kind);
  textures[made.index].name = name;
  named_[{name, kind}] = made;
  parameters.warn_of_unused(context_.warnings);
}

PbrtTextures::Named PbrtTextures::add(const TextureModel& model, const Rgb& mean) {
  textures.push_back({"", model});
  return {std::uint32_t(textures.size() - 1), mean};
}

PbrtTextures::Named PbrtTextures::instead(const Rgb& mean, const PbrtParameters& parameters,
                                          const char* why) {
  parameters.place().warn(context_.warnings, fmt::format("{}: the texture's mean stands for it", why));
  return constant(mean);
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
  return add(picture, {0.5f, 0.5f, 1}).index;
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
  return add(ScaleTexture{texture, constant({scale, scale, scale}).index}, {}).index;
}

bool PbrtTextures::is_at_most(std::uint32_t texture, float number) const {
  const auto* constant = std::get_if<ConstantTexture>(&textures[texture].model);
  return constant && !(constant->value.r > number);
}

/// Of the mappings only that by the surface's coordinates is there.
UvTransform PbrtTextures::read_mapping(const PbrtParameters& parameters) {
  const float u = parameters.real("uscale", 1), v = parameters.real("vscale", 1);
  const float du = parameters.real("udelta", 0), dv = parameters.real("vdelta", 0);
  for (const char* unused : {"v1", "v2"}) parameters.find(unused);
  const std::string mapping = parameters.text("mapping", "uv");
  if (mapping != "uv")
    parameters.find("mapping")->place.warn(
        context_.warnings,
        fmt::format("the mapping \"{}\" is not rendered: the surface's own coordinates are used", mapping));
  return {{{u, 0, du}, {0, v, dv}}};
}

PbrtTextures::Named PbrtTextures::make(const std::string& texture_class, const PbrtParameters& parameters,
                                       PictureChannels channels) {
  if (texture_class == "constant") return value(parameters, "value", 1, channels);
  if (texture_class == "imagemap") return read_picture(parameters, channels);
  if (texture_class == "scale") {
    const Named tex = value(parameters, "tex", 1, channels),
                scale = value(parameters, "scale", 1, PictureChannels::number);
    return add(ScaleTexture{tex.index, scale.index}, tex.mean * scale.mean);
  }
  if (texture_class == "mix" || texture_class == "directionmix") {
    const Named first = value(parameters, "tex1", 0, channels),
                second = value(parameters, "tex2", 1, channels);
    const Named amount = value(parameters, "amount", 0.5f, PictureChannels::number);
    parameters.find("dir");
    const Rgb mean = lerp(first.mean, second.mean, amount.mean);
    if (texture_class == "directionmix")
      return instead(mean, parameters, "a mix by direction is not rendered");
    return add(MixTexture{first.index, second.index, amount.index}, mean);
  }
  const UvTransform uv = read_mapping(parameters);
  if (texture_class == "checkerboard") {
    const Named first = value(parameters, "tex1", 1, channels),
                second = value(parameters, "tex2", 0, channels);
    const Rgb mean = (first.mean + second.mean) * 0.5f;
    if (parameters.integer("dimension", 2, {2, 3}) == 3)
      return instead(mean, parameters, "a checkerboard of cubes is not rendered");
    return add(CheckerboardTexture{first.index, second.index, uv}, mean);
  }
  const auto part = [&](const char* name, float usual) {
    return value(parameters, name, usual, channels).mean;
  };
  if (texture_class == "bilerp")
    return instead((part("v00", 0) + part("v01", 1) + part("v10", 0) + part("v11", 1)) * 0.25f, parameters,
                   "colors between corners are not rendered");
  if (texture_class == "dots") {
    // Every other square has a dot, whose radius is 0.35 of its side.
    constexpr float inside = 0.5f * pi * 0.35f * 0.35f;
    return instead(lerp(part("outside", 0), part("inside", 1), white * inside), parameters,
                   "dots are not rendered");
  }
  for (const char* known : {"octaves", "roughness", "scale", "variation", "filename", "encoding"})
    parameters.find(known);
  parameters.place().warn(context_.warnings, "this pattern is not rendered: 0.5 stands for it");
  return constant({0.5f, 0.5f, 0.5f});
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

PbrtTextures::Named PbrtTextures::read_picture(const PbrtParameters& parameters, PictureChannels channels) {
  ImageTexture picture;
  picture.uv = read_mapping(parameters);
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
  const MipMap& map = *loaded.image;
  const Rgb mean = map.level(map.levels() - 1).at(0, 0);
  const Named read = add(picture, mean);
  const float scale = parameters.real("scale", 1);
  const Named result = scale == 1 ? read : Named{scaled(read.index, scale), mean * scale};
  return parameters.flag("invert", false) ? inverted(result) : result;
}

PbrtTextures::Named PbrtTextures::inverted(const Named& from) {
  return {add_affine(textures, from.index, white * -1, white), white - from.mean};
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
