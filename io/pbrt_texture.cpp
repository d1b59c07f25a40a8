// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/image_file.h"
#include "io/pbrt_spectrum.h"

namespace twinray {
namespace {

constexpr std::array<std::string_view, 13> classes{
    "constant", "scale", "mix",    "directionmix", "imagemap", "checkerboard", "dots",
    "bilerp",   "fbm",   "marble", "windy",        "wrinkled", "ptex"};

/// What only says where a pattern lies and how it is filtered.
constexpr std::array placement{
    "mapping", "uscale",        "vscale",   "udelta",    "vdelta",  "v1",        "v2",        "filter",
    "wrap",    "maxanisotropy", "encoding", "dimension", "octaves", "roughness", "variation", "dir"};

Rgb mean_color(const Image& image) {
  double r = 0, g = 0, b = 0;
  for (const Rgb& pixel : image.pixels) r += double(pixel.r), g += double(pixel.g), b += double(pixel.b);
  const double n = double(image.pixels.size());
  return {float(r / n), float(g / n), float(b / n)};
}

Rgb lerp(const Rgb& a, const Rgb& b, const Rgb& amount) { return a + (b - a) * amount; }

}  // namespace

void PbrtTextures::define(const std::string& name, const std::string& type, const std::string& texture_class,
                          const PbrtParameters& parameters) {
  if (type != "float" && type != "spectrum")
    parameters.place().fail(
        fmt::format("the texture \"{}\" is of type \"{}\"; valid are float and spectrum", name, type));
  if (std::find(classes.begin(), classes.end(), texture_class) == classes.end())
    parameters.place().fail(
        fmt::format("there is no texture class \"{}\"; valid are {}", texture_class, list_names(classes)));
  if (textures_.count(name) > 0)
    parameters.place().warn(
        context_.warnings,
        fmt::format("the texture \"{}\" is defined a second time; the last one counts", name));
  for (const char* known : placement) parameters.find(known);
  textures_[name] = mean_of(texture_class, parameters);
  parameters.warn_of_unused(context_.warnings);
}

PbrtTextures::Texture PbrtTextures::value(const PbrtParameters& parameters, const char* name,
                                          float fallback) {
  const PbrtParameter* found = parameters.find(name);
  if (!found) return {{fallback, fallback, fallback}, true};
  if (found->type == PbrtType::texture) return {mean(parameters, *found), false};
  return {color_of(parameters, *found, ColorRole::unbounded, context_.files), true};
}

PbrtTextures::Texture PbrtTextures::mean_of(const std::string& texture_class,
                                            const PbrtParameters& parameters) {
  if (texture_class == "constant") return value(parameters, "value", 1);
  if (texture_class == "imagemap") return read_picture(parameters);
  if (texture_class == "scale") {
    const Texture tex = value(parameters, "tex", 1), scale = value(parameters, "scale", 1);
    return {tex.mean * scale.mean, tex.is_constant && scale.is_constant};
  }
  if (texture_class == "mix" || texture_class == "directionmix") {
    const Texture first = value(parameters, "tex1", 0), second = value(parameters, "tex2", 1);
    return {lerp(first.mean, second.mean, value(parameters, "amount", 0.5f).mean), false};
  }
  if (texture_class == "checkerboard" || texture_class == "dots") {
    const bool is_checker = texture_class == "checkerboard";
    const Texture first = value(parameters, is_checker ? "tex1" : "inside", 1);
    return {(first.mean + value(parameters, is_checker ? "tex2" : "outside", 0).mean) * 0.5f, false};
  }
  if (texture_class == "bilerp") {
    Rgb sum;
    for (const auto& [name, fallback] : {std::pair{"v00", 0.0f}, {"v01", 1.0f}, {"v10", 0.0f}, {"v11", 1.0f}})
      sum += value(parameters, name, fallback).mean;
    return {sum * 0.25f, false};
  }
  for (const char* known : {"scale", "filename"}) parameters.find(known);
  return {{0.5f, 0.5f, 0.5f}, false};
}

PbrtTextures::Texture PbrtTextures::read_picture(const PbrtParameters& parameters) {
  constexpr Rgb magenta{1, 0, 1};
  const std::string name = parameters.text("filename", "");
  if (name.empty()) parameters.place().fail("an imagemap needs its picture, \"string filename\"");
  const float scale = parameters.real("scale", 1);
  const bool is_inverted = parameters.flag("invert", false);
  const PbrtPlace& place = parameters.find("filename")->place;
  try {
    if (!context_.files.is_disk()) throw Error(name + ": pictures are read from disk alone");
    const Rgb mean = mean_color(read_image(context_.files.path(place, name))) * scale;
    return {is_inverted ? Rgb{1, 1, 1} - mean : mean, false};
  } catch (const Error& error) {
    place.warn(context_.warnings, fmt::format("{}; it shows as magenta", error.what()));
    return {magenta, true};
  }
}

Rgb PbrtTextures::mean(const PbrtParameters& parameters, const PbrtParameter& parameter) {
  const std::string& name = parameters.text(parameter);
  const auto found = textures_.find(name);
  if (found == textures_.end())
    parameter.place.fail(fmt::format("no texture \"{}\" is defined before this", name));
  if (!found->second.is_constant)
    parameter.place.warn(context_.warnings,
                         fmt::format("the texture \"{}\" is not rendered: its mean stands for it", name));
  return found->second.mean;
}

}  // namespace twinray
