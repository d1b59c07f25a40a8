// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/layers.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/textured_material.h"
#include "io/facet_direction.h"
#include "io/gltf/context.h"

namespace twinray {
namespace {

using enum MaterialInput;

constexpr float most_ior = 1000;

class Layers {
 public:
  Layers(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs)
      : source_(source), pointer_(pointer), inputs_(inputs), model_(inputs.model) {}

  void read() {
    read_ior();
    read_specular();
    read_anisotropy();
    read_transmission();
    read_film();
    read_coat();
    read_sheen();
  }

 private:
  GltfExtension extension(const char* name) const { return {source_.extensions, name, pointer_}; }

  /// 0 stands for a surface that reflects all light, as does an index without end.
  void read_ior() {
    if (extension(glossiness_extension)) return;
    const GltfExtension refraction = extension("KHR_materials_ior");
    const float ior = refraction.number("ior", 1.5f);
    if (ior > 0 && ior < 1)
      inputs_.context.warn(refraction.pointer() + "/ior",
                           fmt::format("an index of refraction of {:g} is rendered as 1; valid are 0, and "
                                       "those from 1",
                                       ior));
    model_.specular_ior = ior == 0 ? most_ior : std::max(ior, 1.0f);
  }

  bool has_texture(MaterialInput input) const { return texture_use(inputs_.material, input) != nullptr; }
  bool is_all_metal() const { return model_.base_metalness == 1 && !has_texture(base_metalness); }

  /// The extension changes dielectrics alone; OpenPBR's numbers metals, too.
  void read_specular() {
    const GltfExtension specular = extension("KHR_materials_specular");
    if (!specular || is_all_metal() || extension(glossiness_extension)) return;
    if (!keeps_refraction(specular)) read_specular_weight(specular);
    const Rgb color = specular.color("specularColorFactor", {1, 1, 1});
    model_.specular_color = {std::min(color.r, 1.0f), std::min(color.g, 1.0f), std::min(color.b, 1.0f)};
    if (model_.specular_color != color)
      inputs_.context.warn(specular.pointer() + "/specularColorFactor",
                           "a specular color above 1 is not rendered; it is 1");
    inputs_.color(specular_color, specular.slot("specularColorTexture"), model_.specular_color);
    spare_metal(specular_weight, white * model_.specular_weight);
    spare_metal(specular_color, model_.specular_color);
    if (has_texture(base_metalness)) return;
    const float metal = model_.base_metalness;
    model_.specular_weight += (1 - model_.specular_weight) * metal;
    model_.specular_color = model_.specular_color * (1 - metal) + white * metal;
  }

  void read_specular_weight(const GltfExtension& specular) {
    model_.specular_weight = specular.number("specularFactor", 1);
    inputs_.number(specular_weight, specular.slot("specularTexture"), PictureChannels::alpha,
                   model_.specular_weight);
  }

  /// OpenPBR's weight changes the index of refraction, and with it what is seen through a body.
  bool keeps_refraction(const GltfExtension& specular) {
    const bool is_body = extension("KHR_materials_transmission").number("transmissionFactor", 0) > 0 &&
                         extension("KHR_materials_volume").number("thicknessFactor", 0) > 0;
    if (!is_body || (specular.number("specularFactor", 1) == 1 && !specular.slot("specularTexture")))
      return false;
    inputs_.context.warn(
        specular.pointer(),
        "the specular factor of a body that light goes through is left out: it reflects by its "
        "index of refraction");
    return true;
  }

  /// Where the input, or how much of the surface is metal, is a texture: mixes 1 into it as metal says.
  void spare_metal(MaterialInput input, const Rgb& value) {
    Material& material = inputs_.material;
    const TextureUse* const metal = texture_use(material, base_metalness);
    TextureUse* const use = texture_use(material, input);
    if (!metal && (!use || model_.base_metalness == 0)) return;
    GltfTextures& textures = inputs_.textures;
    const std::uint32_t amount = metal ? metal->texture : textures.constant(white * model_.base_metalness);
    const std::uint32_t first = use ? use->texture : textures.constant(value);
    const std::uint32_t spared = textures.add("", MixTexture{first, textures.constant(white), amount});
    if (use)
      use->texture = spared;
    else if (value != white)
      material.textures.push_back({input, spared});
  }

  /// A texture's red and green are the tangent, its blue is a factor of the strength.
  void read_anisotropy() {
    const GltfExtension anisotropy = extension("KHR_materials_anisotropy");
    const float strength = anisotropy.number("anisotropyStrength", 0);
    if (strength == 0) return;
    if (inputs_.uv_set < 0) inputs_.context.warn(anisotropy.pointer(), no_facet_direction);
    const GltfSlot picture = anisotropy.slot("anisotropyTexture");
    const bool has_picture = inputs_.can_use(picture);
    const double degrees = double(anisotropy.number("anisotropyRotation", 0)) / radians_per_degree;
    const auto turned = float(std::remainder(degrees, degrees_per_turn));
    Material& material = inputs_.material;
    material.tangent_degrees = inputs_.is_mirrored ? -turned : turned;
    if (has_picture) {
      material.tangent_map = inputs_.textures.tangent_map(picture, inputs_.is_mirrored);
      inputs_.number(specular_roughness_anisotropy, picture, PictureChannels::blue, strength);
    } else if (has_texture(roughness)) {
      material.textures.push_back(
          {specular_roughness_anisotropy, inputs_.textures.constant({strength, strength, strength})});
    } else {
      return widen(model_, strength);
    }
    material.textures.back().meaning = InputMeaning::widening;
  }

  /// Without a thickness the surface is a sheet; with one the boundary of a body, within which light is
  /// absorbed. Light that goes through a boundary is times the base color.
  void read_transmission() {
    const GltfExtension transmission = extension("KHR_materials_transmission");
    model_.transmission_weight = transmission.number("transmissionFactor", 0);
    if (model_.transmission_weight == 0) return;
    inputs_.number(transmission_weight, transmission.slot("transmissionTexture"), PictureChannels::red,
                   model_.transmission_weight);
    model_.transmission_color = model_.base_color;
    if (const TextureUse* tint = texture_use(inputs_.material, reflectance))
      inputs_.material.textures.push_back({transmission_color, tint->texture});
    const GltfExtension volume = extension("KHR_materials_volume");
    model_.geometry_thin_walled = !(volume.number("thicknessFactor", 0) > 0);
    Interior& interior = inputs_.material.interior;
    const bool is_body = lets_light_in({.model = model_, .textures = inputs_.material.textures});
    if (is_body) interior.absorption = absorption(volume);
    interior.is_clear = is_body && is_black(interior.absorption);
  }

  /// The color is reached after the distance: e^(-a d) = c.
  static Rgb absorption(const GltfExtension& volume) {
    if (!volume.has("attenuationDistance")) return {};
    constexpr float least = 1e-4f, most = 1e9f;
    const float distance = volume.number("attenuationDistance", 1);
    const auto channel = [&](float c) {
      return std::clamp(-log_of(std::max(c, least)) / distance, 0.0f, most);
    };
    const Rgb color = volume.color("attenuationColor", {1, 1, 1});
    return {channel(color.r), channel(color.g), channel(color.b)};
  }

  /// Thicknesses are in nanometers there.
  void read_film() {
    const GltfExtension film = extension("KHR_materials_iridescence");
    model_.thin_film_weight = film.number("iridescenceFactor", 0);
    if (model_.thin_film_weight == 0) return;
    constexpr float nanometer = 1e-3f;
    const float at_0 = film.number("iridescenceThicknessMinimum", 100) * nanometer;
    const float at_1 = film.number("iridescenceThicknessMaximum", 400) * nanometer;
    model_.thin_film_ior = film.number("iridescenceIor", 1.3f);
    model_.thin_film_thickness = at_1;
    inputs_.number(thin_film_weight, film.slot("iridescenceTexture"), PictureChannels::red,
                   model_.thin_film_weight);
    inputs_.between(thin_film_thickness, film.slot("iridescenceThicknessTexture"), PictureChannels::green,
                    at_0, at_1);
  }

  /// Of an index of 1.5, which takes from what is below it no more than it reflects. What is below reflects
  /// as against air; OpenPBR's meets the coat.
  void read_coat() {
    const GltfExtension coat = extension("KHR_materials_clearcoat");
    model_.coat_weight = coat.number("clearcoatFactor", 0);
    if (model_.coat_weight == 0) return;
    model_.coat_ior = 1.5f;
    model_.coat_darkening = 0;
    model_.coat_roughness = coat.number("clearcoatRoughnessFactor", 0);
    inputs_.number(coat_weight, coat.slot("clearcoatTexture"), PictureChannels::red, model_.coat_weight);
    inputs_.number(coat_roughness, coat.slot("clearcoatRoughnessTexture"), PictureChannels::green,
                   model_.coat_roughness);
    if (has_even_coat(inputs_.material, model_))
      model_.specular_ior = std::min(most_ior, model_.specular_ior * above_base(model_));
    if (coat.slot("clearcoatNormalTexture"))
      inputs_.context.warn(
          coat.pointer() + "/clearcoatNormalTexture",
          "a normal map of the coat alone is not rendered: the coat has the surface's normal");
  }

  /// The largest channel says how much of what is below is hidden, point by point.
  void read_sheen() {
    const GltfExtension sheen = extension("KHR_materials_sheen");
    const Rgb color = sheen.color("sheenColorFactor", {0, 0, 0});
    if (is_black(color)) return;
    set_fuzz(model_, color);
    model_.fuzz_roughness = sheen.number("sheenRoughnessFactor", 0);
    const GltfSlot picture = sheen.slot("sheenColorTexture");
    inputs_.color(fuzz_color, picture, color);
    if (inputs_.coordinates(picture)) inputs_.material.textures.back().meaning = InputMeaning::weighted_color;
    inputs_.number(fuzz_roughness, sheen.slot("sheenRoughnessTexture"), PictureChannels::alpha,
                   model_.fuzz_roughness);
  }

  const tinygltf::Material& source_;
  const std::string& pointer_;
  GltfInputs& inputs_;
  Principled& model_;
};

}  // namespace

void read_layers(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs) {
  Layers(source, pointer, inputs).read();
}

}  // namespace twinray
