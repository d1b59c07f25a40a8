// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/shading_map.h"
#include "core/textured_material.h"
#include "io/gltf/layers.h"
#include "io/vertex_colors.h"

namespace twinray {
namespace {

using enum MaterialInput;

constexpr std::size_t red = 0, green = 1, blue = 2;

/// The ends of a mix of two numbers; none of another texture.
std::optional<std::pair<float, float>> ends_of(const Scene& scene, std::uint32_t texture) {
  const auto* mix = std::get_if<MixTexture>(&scene.textures[texture].model);
  if (!mix) return std::nullopt;
  const auto* at_0 = std::get_if<ConstantTexture>(&scene.textures[mix->first].model);
  const auto* at_1 = std::get_if<ConstantTexture>(&scene.textures[mix->second].model);
  if (!at_0 || !at_1) return std::nullopt;
  return std::pair{at_0->value.r, at_1->value.r};
}
std::uint32_t amount_of(const Scene& scene, std::uint32_t mix) {
  return std::get<MixTexture>(scene.textures[mix].model).amount;
}

/// A hole where a texture is below a limit, as the reader of glTF makes it: a mix of two numbers far apart.
struct Mask {
  std::uint32_t texture;
  float limit;
};
std::optional<Mask> mask_of(const Scene& scene, std::uint32_t alpha) {
  constexpr float least_step = 256;
  const auto ends = ends_of(scene, alpha);
  if (!ends || !(ends->second - ends->first >= least_step)) return std::nullopt;
  return Mask{amount_of(scene, alpha), (1 - ends->first) / (ends->second - ends->first)};
}

/// The texture that makes holes, before a limit cuts it off.
std::uint32_t uncut(const Scene& scene, std::uint32_t alpha) {
  if (alpha == no_texture) return no_texture;
  const auto mask = mask_of(scene, alpha);
  return mask ? mask->texture : alpha;
}

bool is_drawn(const Scene& scene, std::uint32_t texture) {
  return texture != no_texture && is_drawn_of_vertices(scene.textures, texture);
}

/// The texture of what a material reflects, or no_texture.
std::uint32_t color_of(const Material& material) {
  const TextureUse* const use = texture_use(material, reflectance);
  return use ? use->texture : no_texture;
}

/// Whether a texture has this meaning for a material.
bool has_meaning(const Material& material, InputMeaning meaning) {
  return std::any_of(material.textures.begin(), material.textures.end(),
                     [=](const TextureUse& use) { return use.meaning == meaning; });
}

/// The JSON of one material, but for what it emits.
class Properties {
 public:
  Properties(const GltfStandIn& made, GltfFile& file, GltfTextureWriter& textures)
      : made_(made),
        model_(std::get<Principled>(made.material.model)),
        uses_(made.material.textures),
        file_(file),
        textures_(textures) {
    if (!made.material.name.empty()) json_["name"] = made.material.name;
  }

  GltfJson make(const Scene& scene, std::uint32_t alpha, bool is_mirrored) {
    add_base(scene, alpha, is_mirrored);
    add_index();
    add_transmission();
    add_film(scene);
    add_coat();
    add_sheen();
    add_maps(is_mirrored);
    for (const TextureUse& use : uses_) {
      const std::string name = input_name(use.input);
      file_.output.losses.add(fmt::format("a texture of a material's {} is left out", name),
                              fmt::format("{{}} textures of materials' {} are left out", name));
    }
    return std::move(json_);
  }

 private:
  /// Roughness across, and the strength by which they are wider along.
  struct Facets {
    float roughness, strength;
    bool is_widened = false;  ///< By a texture, which has the strength.
  };

  /// The texture of an input, which counts as written; no_texture if there is none.
  std::uint32_t take(MaterialInput input) {
    const auto found =
        std::find_if(uses_.begin(), uses_.end(), [&](const TextureUse& use) { return use.input == input; });
    if (found == uses_.end()) return no_texture;
    const std::uint32_t texture = found->texture;
    uses_.erase(found);
    return texture;
  }
  /// Stays there until another one is added.
  GltfJson& extension(const char* name) {
    file_.use(name);
    return json_["extensions"][name];
  }
  void put(GltfJson& object, const char* property, const GltfChannels& channels) {
    if (!channels.is_empty()) object[property] = textures_.info(channels);
  }
  /// A number, and the texture that stands in place of it in one channel.
  void put_number(GltfJson& object, const char* factor, const char* texture, std::size_t channel,
                  std::pair<MaterialInput, float> input) {
    GltfChannels channels;
    channels.number[channel] = take(input.first);
    object[factor] = channels.is_empty() ? shortest_decimal(input.second) : 1.0;
    put(object, texture, channels);
  }

  void add_base(const Scene& scene, std::uint32_t alpha, bool is_mirrored) {
    GltfJson base;
    GltfChannels color{.color = take(reflectance)};
    float opacity = 1;
    if (alpha != no_texture) opacity = add_alpha(scene, alpha, color);
    GltfJson factor = gltf_color(color.color == no_texture ? model_.base_color : white * model_.base_weight);
    if (color.color != no_texture)
      if (const auto* even = std::get_if<ConstantTexture>(&scene.textures[color.color].model)) {
        factor = gltf_color(within_unit(even->value) *
                            model_.base_weight);  // What has no texture coordinates shows no picture.
        color.color = no_texture;
      }
    if (is_drawn(scene, color.color)) color.color = no_texture;  // Its vertices have the color.
    factor.push_back(shortest_decimal(opacity));
    base["baseColorFactor"] = factor;
    put(base, "baseColorTexture", color);
    const Facets facets = read_facets();
    GltfChannels rough{.power = made_.roughness_power};
    rough.number[green] = take(roughness), rough.number[blue] = take(base_metalness);
    const bool is_rough = rough.number[green] != no_texture, is_metal = rough.number[blue] != no_texture;
    base["metallicFactor"] = is_metal ? 1.0 : shortest_decimal(model_.base_metalness);
    base["roughnessFactor"] = is_rough ? 1.0 : shortest_decimal(facets.roughness);
    put(base, "metallicRoughnessTexture", rough);
    json_["pbrMetallicRoughness"] = base;
    if (facets.is_widened || facets.strength > 0) add_anisotropy(scene, facets, is_mirrored);
  }

  void add_anisotropy(const Scene& scene, const Facets& facets, bool is_mirrored) {
    const Material& material = made_.material;
    GltfJson& json = extension("KHR_materials_anisotropy");
    const float degrees = is_mirrored ? -material.tangent_degrees : material.tangent_degrees;
    if (degrees != 0)
      json["anisotropyRotation"] = shortest_decimal(float(double(degrees) * radians_per_degree));
    GltfChannels channels{
        .color = material.tangent_map, .kind = GltfColorKind::tangent, .turns_green = is_mirrored};
    json["anisotropyStrength"] = shortest_decimal(facets.strength);
    if (facets.is_widened) {
      const std::uint32_t texture = take(specular_roughness_anisotropy);
      const auto* constant = std::get_if<ConstantTexture>(&scene.textures[texture].model);
      if (!constant) channels.number[blue] = texture;
      json["anisotropyStrength"] =
          constant ? shortest_decimal(std::clamp(constant->value.r, 0.0f, 1.0f)) : 1.0;
    }
    put(json, "anisotropyTexture", channels);
  }

  /// Sets the mode; a constant alpha is returned, all else is a channel of the base color's picture.
  float add_alpha(const Scene& scene, std::uint32_t alpha, GltfChannels& color) {
    const auto mask = mask_of(scene, alpha);
    json_["alphaMode"] = mask ? "MASK" : "BLEND";
    if (mask) json_["alphaCutoff"] = shortest_decimal(std::max(mask->limit, 0.0f));
    const std::uint32_t texture = uncut(scene, alpha);
    if (is_drawn(scene, texture)) return 1;  // Its vertices have it.
    if (const auto* constant = std::get_if<ConstantTexture>(&scene.textures[texture].model))
      return std::clamp(constant->value.r, 0.0f, 1.0f);
    color.number[alpha_channel] = texture;
    return 1;
  }

  /// The extension keeps the width across, and widens along: the inverse of widen()
  /// (core/textured_material.h).
  Facets read_facets() const {
    const float rough = model_.specular_roughness, ratio = 1 - model_.specular_roughness_anisotropy;
    if (has_meaning(made_.material, InputMeaning::widening)) return {rough, 0, true};
    if (ratio == 1) return {rough, 0};
    const float along = rough * rough / std::sqrt((1 + ratio * ratio) / 2), across = ratio * along;
    const float strength = across < 1 ? std::sqrt(std::max(0.0f, (along - across) / (1 - across))) : 0;
    return {std::sqrt(across), std::min(strength, 1.0f)};
  }

  /// In glTF a base reflects as against air, below a coat, too (io/gltf/layers.cpp).
  float ior_to_air() const {
    if (!has_even_coat(made_.material, model_)) return model_.specular_ior;
    const float ior = model_.specular_ior / above_base(model_);
    return ior < 1 ? 1 / ior : ior;
  }

  /// glTF's specular reflection is that of a dielectric alone: OpenPBR's is read as a part of it that the
  /// metal lifts towards 1 (io/gltf/layers.cpp).
  float without_metal(float number) const {
    const float metal = model_.base_metalness;
    if (metal == 1 || texture_use(made_.material, base_metalness)) return number;
    return std::max(0.0f, (number - metal) / (1 - metal));
  }

  void add_index() {
    if (model_.specular_ior < 1)
      file_.output.losses.add("a material's index of refraction below 1 is 1",
                              "{} materials' indices of refraction below 1 are 1");
    const float ior = ior_to_air();
    if (ior != 1.5f) extension("KHR_materials_ior")["ior"] = shortest_decimal(std::max(1.0f, ior));
    const auto is_specular = [](const TextureUse& use) {
      return use.input == specular_weight || use.input == specular_color;
    };
    const bool has_texture = std::any_of(uses_.begin(), uses_.end(), is_specular);
    if (model_.specular_weight == 1 && model_.specular_color == white && !has_texture) return;
    GltfJson& json = extension("KHR_materials_specular");
    put_number(json, "specularFactor", "specularTexture", alpha_channel,
               {specular_weight, without_metal(model_.specular_weight)});
    const GltfChannels color{.color = take(specular_color)};
    const Rgb& given = model_.specular_color;
    const Rgb spared{without_metal(given.r), without_metal(given.g), without_metal(given.b)};
    json["specularColorFactor"] = gltf_color(color.is_empty() ? spared : white);
    put(json, "specularColorTexture", color);
  }

  void add_transmission() {
    if (model_.transmission_weight == 0) return;
    take(transmission_color);  // That of the base.
    put_number(extension("KHR_materials_transmission"), "transmissionFactor", "transmissionTexture", red,
               {transmission_weight, model_.transmission_weight});
    if (model_.geometry_thin_walled) return;
    GltfJson& volume = extension("KHR_materials_volume");
    volume["thicknessFactor"] = 1.0;
    const Rgb& absorption = made_.material.interior.absorption;
    const float most = max_component(absorption);
    if (made_.material.interior.priority != 0)
      file_.output.losses.add("the priority of a body that overlaps others is left out",
                              "the priorities of {} materials of bodies that overlap are left out");
    if (!is_black(made_.material.interior.scattering))
      file_.output.losses.add("what a body scatters within is left out",
                              "what {} materials' bodies scatter within is left out");
    if (made_.material.interior.emits())
      file_.output.losses.add("the light that a body's medium emits is left out",
                              "the light that {} materials' bodies emit within is left out");
    if (made_.material.interior.density != no_density)
      file_.output.losses.add("a body whose medium is not even is filled evenly",
                              "{} materials' bodies, whose media are not even, are filled evenly");
    if (most == 0) return;
    // The color after the way at which the strongest channel is down to 1/e.
    constexpr float log2_e = 1.442695f;
    const auto channel = [&](float a) { return float(exp2_of(-double(a / most) * double(log2_e))); };
    volume["attenuationDistance"] = shortest_decimal(1 / most);
    volume["attenuationColor"] =
        gltf_color({channel(absorption.r), channel(absorption.g), channel(absorption.b)});
  }

  void add_film(const Scene& scene) {
    if (model_.thin_film_weight == 0) return;
    constexpr float nanometers = 1000;
    GltfJson& film = extension("KHR_materials_iridescence");
    put_number(film, "iridescenceFactor", "iridescenceTexture", red,
               {thin_film_weight, model_.thin_film_weight});
    film["iridescenceIor"] = shortest_decimal(model_.thin_film_ior);
    std::pair ends{model_.thin_film_thickness, model_.thin_film_thickness};
    GltfChannels thickness;
    if (const std::uint32_t texture = take(thin_film_thickness); texture != no_texture) {
      const auto own = ends_of(scene, texture);
      ends = own.value_or(std::pair{0.0f, 1.0f});
      thickness.number[green] = own ? amount_of(scene, texture) : texture;
      if (!own && !std::holds_alternative<ImageTexture>(scene.textures[texture].model))
        file_.output.losses.add("what is above 1 micrometer of a thin film's thickness is written as 1",
                                "what is above 1 micrometer of {} thin films' thicknesses is written as 1");
    }
    film["iridescenceThicknessMinimum"] = shortest_decimal(ends.first * nanometers);
    film["iridescenceThicknessMaximum"] = shortest_decimal(ends.second * nanometers);
    put(film, "iridescenceThicknessTexture", thickness);
  }

  void add_coat() {
    if (model_.coat_weight == 0) return;
    GltfJson& coat = extension("KHR_materials_clearcoat");
    put_number(coat, "clearcoatFactor", "clearcoatTexture", red, {coat_weight, model_.coat_weight});
    GltfChannels rough{.power = made_.roughness_power};
    rough.number[green] = take(coat_roughness);
    coat["clearcoatRoughnessFactor"] = rough.is_empty() ? shortest_decimal(model_.coat_roughness) : 1.0;
    put(coat, "clearcoatRoughnessTexture", rough);
  }

  void add_sheen() {
    if (model_.fuzz_weight == 0) return;
    GltfJson& sheen = extension("KHR_materials_sheen");
    const bool is_weighted = has_meaning(made_.material, InputMeaning::weighted_color);
    const GltfChannels color{.color = take(fuzz_color)};
    const float most = max_component(model_.fuzz_color);
    const Rgb full = most > 0 ? model_.fuzz_color / most : Rgb{};
    sheen["sheenColorFactor"] =
        gltf_color(is_weighted ? white : (color.is_empty() ? full : white) * model_.fuzz_weight);
    put(sheen, "sheenColorTexture", color);
    put_number(sheen, "sheenRoughnessFactor", "sheenRoughnessTexture", alpha_channel,
               {fuzz_roughness, model_.fuzz_roughness});
  }

  void add_maps(bool is_mirrored) {
    const Material& material = made_.material;
    if (material.normal_map != no_texture)
      put(json_, "normalTexture",
          {.color = material.normal_map, .kind = GltfColorKind::normal, .turns_green = is_mirrored});
    if (material.bump_map != no_texture)
      file_.output.losses.add("a bump map is left out", "{} bump maps are left out");
  }

  const GltfStandIn& made_;
  const Principled& model_;
  std::vector<TextureUse> uses_;  ///< Those that are not written yet.
  GltfFile& file_;
  GltfTextureWriter& textures_;
  GltfJson json_;
};

/// The brightest component of a picture, or 1 if none is above.
float brightest(const Image& picture) {
  float most = 1;
  for (const Rgb& pixel : picture.pixels) most = std::max(most, max_component(pixel));
  return most;
}

}  // namespace

std::size_t GltfMaterialWriter::material(const ShapeBinding& binding, bool is_mirrored) {
  const auto [entry, is_new] =
      made_.try_emplace({binding.material, binding.light, binding.alpha, is_mirrored});
  if (is_new) entry->second = file_.add("materials", make(binding, is_mirrored));
  return entry->second;
}

bool GltfMaterialWriter::needs_handedness(const ShapeBinding& binding) const {
  Losses named_before;
  const Material material = gltf_stand_in(scene_, binding.material, named_before).material;
  return material.normal_map != no_texture || has_tangent(material);
}

std::vector<std::array<float, 4>> GltfMaterialWriter::vertex_colors(const ShapeBinding& binding,
                                                                    std::span<const Vec2> uvs) {
  Losses named_before;
  const std::uint32_t color = color_of(gltf_stand_in(scene_, binding.material, named_before).material);
  const std::uint32_t holes = uncut(scene_, binding.alpha);
  const bool has_color = is_drawn(scene_, color), has_alpha = is_drawn(scene_, holes);
  std::vector<std::array<float, 4>> colors;
  if (!has_color && !has_alpha) return colors;
  for (const Vec2 uv : uvs) {
    const TexturePoint at{.uv = uv, .is_smooth = true};
    const Rgb c = has_color ? evaluate(scene_.textures, color, at) : white;
    const float alpha = has_alpha ? evaluate(scene_.textures, holes, at).r : 1;
    colors.push_back({c.r, c.g, c.b, alpha});
  }
  return colors;
}

GltfJson GltfMaterialWriter::make(const ShapeBinding& binding, bool is_mirrored) {
  const GltfStandIn made = gltf_stand_in(scene_, binding.material, file_.output.losses);
  GltfJson json = Properties(made, file_, textures_).make(scene_, binding.alpha, is_mirrored);
  json["doubleSided"] = true;
  if (binding.light != no_light) add_emission(binding.light, json);
  return json;
}

void GltfMaterialWriter::add_emission(std::uint32_t light, GltfJson& json) {
  const LightSource& source = scene_.lights[light].source;
  const auto* mesh = std::get_if<MeshLight>(&source);
  Rgb radiance = mesh ? mesh->radiance : std::get<SphereLight>(source).radiance;
  if (mesh && mesh->picture) {
    const float most = brightest(*mesh->picture);
    radiance = radiance * most;
    json["emissiveTexture"] = textures_.emission_info(*mesh, most);
  }
  // Readers may refuse more than 10^9.
  constexpr float most_radiance = 0x1p29f;
  if (const float most = max_component(radiance); most > most_radiance) {
    radiance = radiance * (most_radiance / most);
    file_.output.losses.add("a surface that emits is 5 x 10^8 bright, and no more",
                            "{} surfaces that emit are 5 x 10^8 bright, and no more");
  }
  const GltfLight emitted = gltf_light(radiance);
  json["emissiveFactor"] = gltf_color(emitted.color);
  json["doubleSided"] = mesh && mesh->side == EmissionSide::both;
  if (emitted.strength == 1) return;
  file_.use("KHR_materials_emissive_strength");
  json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] =
      shortest_decimal(emitted.strength);
}

}  // namespace twinray
