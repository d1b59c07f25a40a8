// SPDX-License-Identifier: Apache-2.0
#include "io/obj/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle.h"
#include "io/affine_texture.h"
#include "io/obj/material_text.h"
#include "io/picture_path.h"
#include "io/uri.h"

namespace twinray {
namespace {

float unit(float x) { return x > 0 ? std::min(x, 1.0f) : 0; }  // A NaN is 0.

Rgb color_of(const tinyobj::real_t (&from)[3]) { return {from[0], from[1], from[2]}; }
Rgb unit_color(const tinyobj::real_t (&from)[3]) { return {unit(from[0]), unit(from[1]), unit(from[2])}; }

/// Whether a colour lies between 0 and `most`, but for what the conversion of CIE's colours rounds.
bool is_within(const Rgb& color, float most) {
  constexpr float margin = 1e-3f;
  return color.r >= -margin && color.g >= -margin && color.b >= -margin &&
         max_component(color) <= most + margin;
}

/// Whether one of the values of the extension for physically based rendering stands there: a roughness, also
/// of 0, or another one that is not 0.
bool is_physical(const tinyobj::material_t& m) {
  return m.unknown_parameter.count(roughness_mark) > 0 || m.roughness > 0 || m.metallic > 0 || m.sheen > 0 ||
         m.clearcoat_thickness > 0 || !m.roughness_texname.empty() || !m.metallic_texname.empty() ||
         !m.sheen_texname.empty();
}

/// Phong's exponent as a roughness: that of the distribution of facets which is as wide (Walter et al.,
/// "Microfacet Models for Refraction through Rough Surfaces", 2007).
float roughness_of(float exponent) { return std::sqrt(std::sqrt(2 / (std::max(exponent, 0.0f) + 2))); }

Principled physical(const tinyobj::material_t& m) {
  Principled model;
  model.base_color = unit_color(m.diffuse);
  model.base_metalness = unit(m.metallic);
  model.specular_roughness = unit(m.roughness);
  model.specular_roughness_anisotropy = unit(m.anisotropy);
  if (m.ior > 1) model.specular_ior = std::min(m.ior, 10.0f);
  model.coat_weight = unit(m.clearcoat_thickness);
  model.coat_roughness = unit(m.clearcoat_roughness);
  model.fuzz_weight = unit(m.sheen);
  return model;
}

/// A black one beside a picture says nothing: whoever has a picture may leave it out.
Rgb specular_of(const tinyobj::material_t& m) {
  const Rgb color = unit_color(m.specular);
  return is_black(color) && !m.specular_texname.empty() ? white : color;
}

/// A specular colour of 0.5 is that of usual plastic, as Blender writes it.
Principled glossy(const tinyobj::material_t& m) {
  Principled model;
  model.base_color = unit_color(m.diffuse);
  const Rgb specular = specular_of(m);
  model.specular_weight = unit(2 * max_component(specular));
  model.specular_color = specular * (1 / max_component(specular));
  model.specular_roughness = roughness_of(m.shininess);
  return model;
}

/// Illumination models that refract: "transparency: glass on", with and without reflection.
bool refracts(const tinyobj::material_t& m) {
  const bool is_clear = m.dissolve < 1 || !is_black(unit_color(m.transmittance));
  return is_clear && m.ior > 1 && (m.illum == 4 || m.illum == 6 || m.illum == 7 || m.illum == 9);
}

/// Those that mirror: "reflection: ray trace on".
bool mirrors(const tinyobj::material_t& m) {
  return (m.illum == 3 || m.illum == 5) && is_black(unit_color(m.diffuse)) && m.diffuse_texname.empty() &&
         !is_black(unit_color(m.specular));
}

SurfaceModel model_of(const tinyobj::material_t& m) {
  if (refracts(m)) {
    Dielectric glass{.ior = std::min(m.ior, 10.0f)};
    if (const Rgb color = unit_color(m.transmittance); !is_black(color)) glass.transmittance = color;
    return glass;
  }
  if (is_physical(m)) return physical(m);
  if (mirrors(m)) return Mirror{unit_color(m.specular)};
  const bool shines = m.illum >= 2 && !is_black(specular_of(m));
  return shines ? SurfaceModel(glossy(m)) : SurfaceModel(Lambert{unit_color(m.diffuse)});
}

/// Heights are grey; normals point out of the surface, which is blue.
bool shows_normals(const MipMap& map) {
  const Rgb mean = map.level(map.levels() - 1).at(0, 0);
  return mean.b > mean.r + 0.2f && mean.b > mean.g + 0.2f;
}

/// A picture where its options place it.
ImageTexture placed(std::shared_ptr<const MipMap> image, const tinyobj::texture_option_t& how) {
  ImageTexture made{.image = std::move(image)};
  made.uv = {{{how.scale[0], 0, how.origin_offset[0]}, {0, how.scale[1], how.origin_offset[1]}}};
  if (how.clamp) made.wrap = WrapMode::clamp;
  return made;
}

/// What `-mm` makes of a pixel.
Rgb levelled(const Rgb& pixel, const tinyobj::texture_option_t& how) {
  return white * how.brightness + pixel * how.contrast;
}

constexpr PictureMeaning for_colors{PictureRole::color, PictureChannels::color},
    for_vectors{PictureRole::data, PictureChannels::color};

/// What `-imfchan` takes of a picture whose numbers are wanted; without it, `usual`.
PictureMeaning for_numbers(const tinyobj::texture_option_t& how, PictureChannels usual) {
  const auto channels = [&] {
    switch (how.imfchan) {
      case 'r':
        return PictureChannels::red;
      case 'g':
        return PictureChannels::green;
      case 'b':
        return PictureChannels::blue;
      case 'l':
        return PictureChannels::brightness;
      default:  // 'm', the alpha, is the library's word where the file has none.
        return usual;
    }
  };
  return {PictureRole::data, channels()};
}

}  // namespace

void ObjMaterials::warn(const std::string& message) {
  warnings_.add([&] { return Place{file_, 0, 0, "", 0}; }, message);
}

std::string ObjMaterials::path_of(const std::string& name) const {
  return found_picture(path_of_name(with_slashes(name), file_), file_);
}

ObjSurface ObjMaterials::surface(int number) {
  if (number >= 0) file_ = model_.material_files[std::size_t(number)];
  const auto made = made_.find(number);
  if (made != made_.end()) return made->second;
  ObjSurface surface;
  if (number >= 0) {
    surface = make(model_.materials[std::size_t(number)]);
  } else {
    surface.material = std::uint32_t(materials.size());
    materials.push_back({"none", Lambert{}});
  }
  made_.emplace(number, surface);
  return surface;
}

ObjSurface ObjMaterials::painted(const ObjSurface& surface, const ImageTexture& picture) {
  Material material = materials[surface.material];
  material.textures.push_back({MaterialInput::reflectance, std::uint32_t(textures.size())});
  textures.push_back({"colors of vertices", picture});
  ObjSurface result = surface;
  result.material = std::uint32_t(materials.size());
  materials.push_back(std::move(material));
  return result;
}

bool ObjMaterials::is_textured(const ObjSurface& surface) const {
  const Material& material = materials[surface.material];
  const bool has_alpha =
      surface.alpha != no_texture && !std::holds_alternative<ConstantTexture>(textures[surface.alpha].model);
  return has_alpha || surface.glow.picture || !material.textures.empty() ||
         material.normal_map != no_texture || material.bump_map != no_texture;
}

void ObjMaterials::warn_of_ranges(const tinyobj::material_t& from) {
  const std::pair<const char*, float> parts[] = {{"Pr", from.roughness},
                                                 {"Pm", from.metallic},
                                                 {"Ps", from.sheen},
                                                 {"Pc", from.clearcoat_thickness},
                                                 {"Pcr", from.clearcoat_roughness},
                                                 {"aniso", from.anisotropy},
                                                 {"d", from.dissolve}};
  for (const auto& [name, value] : parts)
    if (!(value >= 0 && value <= 1))
      warn(fmt::format("{} of the material \"{}\" is {:g}; the nearest number in [0, 1] is taken", name,
                       from.name, value));
  const std::pair<const char*, Rgb> colors[] = {
      {"Kd", color_of(from.diffuse)}, {"Ks", color_of(from.specular)}, {"Tf", color_of(from.transmittance)}};
  for (const auto& [name, color] : colors)
    if (!is_within(color, 1))
      warn(fmt::format("{} of the material \"{}\" is {:g} {:g} {:g}; the nearest color in [0, 1] is taken",
                       name, from.name, color.r, color.g, color.b));
  if (const Rgb glow = color_of(from.emission); !is_within(glow, std::numeric_limits<float>::infinity()))
    warn(fmt::format("Ke of the material \"{}\" is {:g} {:g} {:g}; 0 is taken for what is negative",
                     from.name, glow.r, glow.g, glow.b));
}

ObjSurface ObjMaterials::make(const tinyobj::material_t& from) {
  warn_of_ranges(from);
  Material material{.name = from.name, .model = model_of(from)};
  material.tangent_degrees = float(degrees_per_turn) * unit(from.anisotropy_rotation);
  add_color(from, material);
  add_textures(from, material);
  add_relief(from, material);
  ObjSurface surface;
  surface.alpha = alpha_of(from, material);
  surface.glow = glow_of(from);
  surface.material = std::uint32_t(materials.size());
  materials.push_back(std::move(material));
  return surface;
}

/// The picture times the colour. A black one says nothing: whoever has a picture may leave it out.
void ObjMaterials::add_color(const tinyobj::material_t& from, Material& to) {
  const bool has_color =
      std::holds_alternative<Principled>(to.model) || std::holds_alternative<Lambert>(to.model);
  if (!has_color || from.diffuse_texname.empty()) return;
  const std::uint32_t texture = picture(from.diffuse_texname, from.diffuse_texopt, for_colors);
  const Rgb color = unit_color(from.diffuse);
  const bool is_whole = is_black(color) || color == white;
  to.textures.push_back({MaterialInput::reflectance, is_whole ? texture : scaled(texture, color)});
}

void ObjMaterials::add_textures(const tinyobj::material_t& from, Material& to) {
  const auto add = [&](const std::string& name, const tinyobj::texture_option_t& how,
                       const PictureMeaning& meaning, MaterialInput input) {
    if (!name.empty()) to.textures.push_back({input, picture(name, how, meaning)});
  };
  if (std::holds_alternative<Principled>(to.model)) {
    const auto add_number = [&](const std::string& name, const tinyobj::texture_option_t& how,
                                MaterialInput input) {
      add(name, how, for_numbers(how, PictureChannels::brightness), input);
    };
    add_number(from.roughness_texname, from.roughness_texopt, MaterialInput::roughness);
    add_number(from.metallic_texname, from.metallic_texopt, MaterialInput::base_metalness);
    add_number(from.sheen_texname, from.sheen_texopt, MaterialInput::fuzz_weight);
  }
  add_specular(from, to);
  if (!from.specular_highlight_texname.empty()) warn("pictures of the exponent (map_Ns) are left out");
  if (!from.displacement_texname.empty()) warn("displacement (disp) is left out");
  if (!from.reflection_texname.empty()) warn("pictures of reflections (refl) are left out");
}

/// The picture times the colour, for the kinds of surfaces that go by it.
void ObjMaterials::add_specular(const tinyobj::material_t& from, Material& to) {
  if (from.specular_texname.empty() || is_physical(from)) return;
  if (std::holds_alternative<Mirror>(to.model)) return warn("pictures of what mirrors (map_Ks) are left out");
  const auto* model = std::get_if<Principled>(&to.model);
  if (!model) return;
  const std::uint32_t texture = picture(from.specular_texname, from.specular_texopt, for_colors);
  const Rgb color = model->specular_color;
  to.textures.push_back({MaterialInput::specular_color, color == white ? texture : scaled(texture, color)});
}

void ObjMaterials::add_relief(const tinyobj::material_t& from, Material& to) {
  const auto add_normals = [&](const std::string& name, const tinyobj::texture_option_t& how) {
    LoadedTexture loaded = load_normal_map(path_of(name), options_);
    if (!loaded.warning.empty()) warn(loaded.warning);
    ImageTexture map = placed(loaded.image, how);
    map.filter = TextureFilter::bilinear;
    textures.push_back({name, map});
    to.normal_map =
        add_leaning(textures, std::uint32_t(textures.size() - 1), how.bump_multiplier, how.bump_multiplier);
  };
  if (!from.normal_texname.empty()) return add_normals(from.normal_texname, from.normal_texopt);
  if (from.bump_texname.empty()) return;
  const LoadedTexture relief = load_texture(path_of(from.bump_texname), for_vectors, options_);
  if (relief.is_stand_in || shows_normals(*relief.image))
    return add_normals(from.bump_texname, from.bump_texopt);
  const tinyobj::texture_option_t& how = from.bump_texopt;
  const std::uint32_t height = picture(from.bump_texname, how, for_numbers(how, PictureChannels::brightness));
  to.bump_map = scaled(height, white * how.bump_multiplier);
}

/// What refracts is whole: light goes through it as it is.
std::uint32_t ObjMaterials::alpha_of(const tinyobj::material_t& from, const Material& made) {
  if (std::holds_alternative<Dielectric>(made.model)) return no_texture;
  const float dissolve = unit(from.dissolve);
  const Rgb share{dissolve, dissolve, dissolve};
  if (from.alpha_texname.empty()) return dissolve < 1 ? constant(share) : no_texture;
  const std::uint32_t alpha =
      picture(from.alpha_texname, from.alpha_texopt, for_numbers(from.alpha_texopt, PictureChannels::number));
  return dissolve == 1 ? alpha : scaled(alpha, share);
}

MeshLight ObjMaterials::glow_of(const tinyobj::material_t& from) {
  if (options_.surfaces_only) return {};
  const Rgb given = color_of(from.emission);
  MeshLight glow{.radiance = at_least_zero(given)};
  if (from.emissive_texname.empty()) return glow;
  const LoadedTexture loaded = load(from.emissive_texname, for_colors);
  if (loaded.is_stand_in) return glow;
  const tinyobj::texture_option_t& how = from.emissive_texopt;
  const ImageTexture map = placed(loaded.image, how);
  if (is_black(glow.radiance)) glow.radiance = white;
  Image picture = loaded.image->image(0);
  for (Rgb& pixel : picture.pixels) pixel = levelled(pixel, how);
  glow.picture = std::make_shared<const Image>(std::move(picture));
  glow.uv = map.uv;
  glow.wrap = map.wrap;
  return glow;
}

LoadedTexture ObjMaterials::load(const std::string& name, const PictureMeaning& meaning) {
  LoadedTexture loaded = load_texture(path_of(name), meaning, options_);
  if (!loaded.warning.empty()) warn(loaded.warning);
  return loaded;
}

std::uint32_t ObjMaterials::picture(const std::string& name, const tinyobj::texture_option_t& how,
                                    const PictureMeaning& meaning) {
  textures.push_back({name, placed(load(name, meaning).image, how)});
  const auto texture = std::uint32_t(textures.size() - 1);
  if (how.brightness == 0 && how.contrast == 1) return texture;
  return add_affine(textures, texture, white * how.contrast, white * how.brightness);
}

std::uint32_t ObjMaterials::constant(const Rgb& value) {
  textures.push_back({"", ConstantTexture{value}});
  return std::uint32_t(textures.size() - 1);
}

std::uint32_t ObjMaterials::scaled(std::uint32_t texture, const Rgb& scale) {
  textures.push_back({"", ScaleTexture{texture, constant(scale)}});
  return std::uint32_t(textures.size() - 1);
}

}  // namespace twinray
