// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/layers.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/elementary.h"
#include "io/gltf/context.h"

namespace twinray {
namespace {

using enum MaterialInput;

class Layers {
 public:
  Layers(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs)
      : source_(source), pointer_(pointer), inputs_(inputs), model_(inputs.model) {}

  void read() {
    read_ior();
    read_specular();
    read_anisotropy();
    read_transmission();
    read_coat();
    read_sheen();
  }

 private:
  GltfExtension extension(const char* name) const { return {source_.extensions, name, pointer_}; }

  /// 0 stands for a surface that reflects all light, as does an index without end.
  void read_ior() {
    if (extension(glossiness_extension)) return;
    constexpr float most = 1000;
    const float ior = extension("KHR_materials_ior").number("ior", 1.5f);
    model_.specular_ior = ior == 0 ? most : std::max(ior, 1.0f);
  }

  bool is_all_metal() const {
    const std::vector<TextureUse>& uses = inputs_.material.textures;
    return model_.base_metalness == 1 && std::none_of(uses.begin(), uses.end(), [](const TextureUse& use) {
             return use.input == base_metalness;
           });
  }

  /// The extension changes dielectrics alone; OpenPBR's numbers metals, too.
  void read_specular() {
    const GltfExtension specular = extension("KHR_materials_specular");
    if (!specular || is_all_metal()) return;
    model_.specular_weight = specular.number("specularFactor", 1);
    inputs_.number(specular_weight, specular.slot("specularTexture"), PictureChannels::alpha,
                   model_.specular_weight);
    const Rgb color = specular.color("specularColorFactor", {1, 1, 1});
    model_.specular_color = {std::min(color.r, 1.0f), std::min(color.g, 1.0f), std::min(color.b, 1.0f)};
    if (model_.specular_color != color)
      inputs_.context.warn(specular.pointer() + "/specularColorFactor",
                           "a specular color above 1 is not rendered; it is 1");
    inputs_.color(specular_color, specular.slot("specularColorTexture"), model_.specular_color);
  }

  /// The extension widens the facets along the tangent, and keeps them across: alpha_t = alpha + (1 - alpha)
  /// s^2. OpenPBR has alpha_t = r^2 sqrt(2 / (1 + (1 - a)^2)) and alpha_b = (1 - a) alpha_t.
  void read_anisotropy() {
    const GltfExtension anisotropy = extension("KHR_materials_anisotropy");
    const float strength = anisotropy.number("anisotropyStrength", 0);
    if (strength == 0) return;
    const float across = model_.specular_roughness * model_.specular_roughness;
    const float along = across + (1 - across) * strength * strength, ratio = across / along;
    model_.specular_roughness_anisotropy = 1 - ratio;
    model_.specular_roughness = std::min(1.0f, std::sqrt(along * std::sqrt((1 + ratio * ratio) / 2)));
    if (anisotropy.number("anisotropyRotation", 0) != 0 || anisotropy.slot("anisotropyTexture"))
      inputs_.context.warn(anisotropy.pointer(),
                           "the direction of anisotropy is that of the texture coordinates; its rotation and "
                           "its texture are not rendered");
    if (std::any_of(inputs_.material.textures.begin(), inputs_.material.textures.end(),
                    [](const TextureUse& use) { return use.input == roughness; }))
      inputs_.context.warn(anisotropy.pointer(),
                           "a surface that has a roughness texture is not widened along its tangent");
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
    const auto tint = std::find_if(inputs_.material.textures.begin(), inputs_.material.textures.end(),
                                   [](const TextureUse& use) { return use.input == reflectance; });
    if (tint != inputs_.material.textures.end())
      inputs_.material.textures.push_back({transmission_color, tint->texture});
    const GltfExtension volume = extension("KHR_materials_volume");
    model_.geometry_thin_walled = !(volume.number("thicknessFactor", 0) > 0);
    if (lets_light_in(model_)) inputs_.material.interior.absorption = absorption(volume);
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

  /// Of an index of 1.5, which takes from what is below it no more than it reflects.
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
    if (coat.slot("clearcoatNormalTexture"))
      inputs_.context.warn(
          coat.pointer() + "/clearcoatNormalTexture",
          "a normal map of the coat alone is not rendered: the coat has the surface's normal");
  }

  /// The largest channel says how much of what is below is hidden.
  void read_sheen() {
    const GltfExtension sheen = extension("KHR_materials_sheen");
    const Rgb color = sheen.color("sheenColorFactor", {0, 0, 0});
    const float weight = max_component(color);
    if (weight == 0) return;
    model_.fuzz_weight = weight;
    model_.fuzz_color = color / weight;
    model_.fuzz_roughness = sheen.number("sheenRoughnessFactor", 0);
    inputs_.color(fuzz_color, sheen.slot("sheenColorTexture"), model_.fuzz_color);
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
