// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/material.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/radiance.h"
#include "io/gltf/document.h"
#include "io/gltf/inputs.h"
#include "io/gltf/layers.h"

namespace twinray {
namespace {

/// The format's default material is what a material without properties is.
const tinygltf::Material& material_at(const GltfDocument& document, int index) {
  static const tinygltf::Material plain;
  return index < 0 ? plain : document.model().materials[std::size_t(index)];
}

Rgb color_of(const std::vector<double>& numbers) {
  if (numbers.size() < 3) return {};
  return {float(numbers[0]), float(numbers[1]), float(numbers[2])};
}

/// The slots of colors and numbers, the base color's first.
std::vector<GltfSlot> input_slots(const tinygltf::Material& source, const std::string& pointer) {
  const GltfSlots slots = slots_of(source, pointer);
  std::vector<GltfSlot> list{slots.base_color, slots.metallic_roughness};
  constexpr std::array<std::pair<const char*, const char*>, 10> further{
      {{glossiness_extension, "diffuseTexture"},
       {"KHR_materials_transmission", "transmissionTexture"},
       {"KHR_materials_clearcoat", "clearcoatTexture"},
       {"KHR_materials_clearcoat", "clearcoatRoughnessTexture"},
       {"KHR_materials_sheen", "sheenColorTexture"},
       {"KHR_materials_sheen", "sheenRoughnessTexture"},
       {"KHR_materials_specular", "specularTexture"},
       {"KHR_materials_specular", "specularColorTexture"},
       {"KHR_materials_iridescence", "iridescenceTexture"},
       {"KHR_materials_iridescence", "iridescenceThicknessTexture"}}};
  for (const auto& [extension, property] : further)
    list.push_back(GltfExtension(source.extensions, extension, pointer).slot(property));
  return list;
}

/// All slots whose texture coordinates matter, the base color's first.
std::vector<GltfSlot> rendered_slots(const tinygltf::Material& source, const std::string& pointer) {
  const GltfSlots slots = slots_of(source, pointer);
  std::vector<GltfSlot> list{slots.base_color, slots.metallic_roughness, slots.normal, slots.emissive};
  for (GltfSlot& slot : input_slots(source, pointer)) list.push_back(std::move(slot));
  const GltfExtension anisotropy(source.extensions, "KHR_materials_anisotropy", pointer);
  list.push_back(anisotropy.slot("anisotropyTexture"));
  return list;
}

/// Whether a material's facets have a direction.
bool is_brushed(const tinygltf::Material& source) {
  return GltfExtension(source.extensions, "KHR_materials_anisotropy", "").number("anisotropyStrength", 0) > 0;
}

class MaterialReader {
 public:
  MaterialReader(const tinygltf::Material& source, const std::string& pointer, GltfInputs& inputs)
      : source_(source), pointer_(pointer), inputs_(inputs), slots_(slots_of(source, pointer)) {}

  GltfSurface read(const GltfUse& use) {
    read_base(use);
    read_alpha(use);
    surface_.glow.side = source_.doubleSided ? EmissionSide::both : EmissionSide::front;
    if (GltfExtension(source_.extensions, "KHR_materials_unlit", pointer_)) {
      make_unlit(use);
      return surface_;
    }
    read_layers(source_, pointer_, inputs_);
    if (inputs_.can_use(slots_.normal))
      inputs_.material.normal_map = inputs_.textures.normal_map(slots_.normal, inputs_.is_mirrored);
    inputs_.material.model = inputs_.model;
    read_emission();
    return surface_;
  }

 private:
  void read_base(const GltfUse& use) {
    const auto& metallic = source_.pbrMetallicRoughness;
    Principled& model = inputs_.model;
    model.base_color = color_of(metallic.baseColorFactor);
    model.base_metalness = float(metallic.metallicFactor);
    model.specular_roughness = float(metallic.roughnessFactor);
    opacity_ = float(metallic.baseColorFactor[3]);
    if (const GltfExtension glossy(source_.extensions, glossiness_extension, pointer_); glossy)
      read_glossiness(glossy);
    read_color(use);
    inputs_.number(MaterialInput::base_metalness, slots_.metallic_roughness, PictureChannels::blue,
                   model.base_metalness);
    inputs_.number(MaterialInput::roughness, slots_.metallic_roughness, PictureChannels::green,
                   model.specular_roughness);
  }

  /// A dielectric of any index and color: so are metals here, too. What is unlit shows its diffuse color.
  void read_glossiness(const GltfExtension& glossy) {
    constexpr float highest_ior = 1000;
    Principled& model = inputs_.model;
    const Rgb specular = glossy.color("specularFactor", {1, 1, 1});
    const float reflected = max_component(specular), root = std::sqrt(reflected);
    const bool is_unlit = bool(GltfExtension(source_.extensions, "KHR_materials_unlit", pointer_));
    slots_.base_color = glossy.slot("diffuseTexture");
    slots_.metallic_roughness = {};
    model.base_color = glossy.color("diffuseFactor", {1, 1, 1}) * (is_unlit ? 1 : 1 - reflected);
    model.base_metalness = 0;
    model.specular_roughness = 1 - glossy.number("glossinessFactor", 1);
    model.specular_ior = root < 1 ? std::min((1 + root) / (1 - root), highest_ior) : highest_ior;
    if (reflected > 0) model.specular_color = specular / reflected;
    opacity_ = glossy.component("diffuseFactor", 3, 1);
    if (glossy.slot("specularGlossinessTexture") && !is_unlit)
      inputs_.context.warn(glossy.pointer() + "/specularGlossinessTexture",
                           "this texture is not rendered: its factors hold all over");
  }

  /// The base color is a factor times a picture times the vertices' colors.
  void read_color(const GltfUse& use) {
    std::uint32_t texture = use.color;
    if (inputs_.can_use(slots_.base_color))
      texture = inputs_.textures.product(
          inputs_.textures.picture(slots_.base_color, {PictureRole::color, PictureChannels::color}), texture);
    if (texture != no_texture)
      inputs_.material.textures.push_back(
          {MaterialInput::reflectance, inputs_.textures.scaled(texture, inputs_.model.base_color)});
  }

  /// The texture whose red is the surface's alpha but for the factor, or no_texture where that is 1.
  std::uint32_t alpha_texture(const GltfUse& use) {
    if (!slots_.base_color || slots_.base_color.uv_set != inputs_.uv_set) return use.alpha;
    const PictureMeaning meaning{PictureRole::data, PictureChannels::alpha};
    return inputs_.textures.product(inputs_.textures.picture(slots_.base_color, meaning), use.alpha);
  }

  void read_alpha(const GltfUse& use) {
    if (source_.alphaMode == "OPAQUE") return;
    const float factor = opacity_;
    const std::uint32_t texture = alpha_texture(use);
    GltfTextures& textures = inputs_.textures;
    if (source_.alphaMode == "MASK") {
      const auto limit = float(source_.alphaCutoff);
      if (texture != no_texture)
        surface_.alpha = textures.at_least(texture, factor, limit);
      else if (factor < limit)
        surface_.alpha = textures.constant({0, 0, 0});
    } else if (texture != no_texture) {
      surface_.alpha = textures.scaled(texture, {factor, factor, factor});
    } else if (factor < 1) {
      surface_.alpha = textures.constant({factor, factor, factor});
    }
  }

  /// What emits its base color and reflects nothing looks the same in any light.
  void make_unlit(const GltfUse& use) {
    inputs_.material.model = Lambert{{0, 0, 0}};
    inputs_.material.textures.clear();
    surface_.glow.radiance = inputs_.model.base_color;
    surface_.glow.side = EmissionSide::both;
    set_glow(slots_.base_color);
    if (use.color == no_texture) return;
    const TextureModel& color = inputs_.textures.textures()[use.color].model;
    if (const auto* same = std::get_if<ConstantTexture>(&color))
      surface_.glow.radiance = surface_.glow.radiance * same->value;
    else if (const auto* picture = std::get_if<ImageTexture>(&color))
      surface_.glow.picture = std::make_shared<const Image>(picture->image->image(0));
  }

  void read_emission() {
    const GltfExtension strength(source_.extensions, "KHR_materials_emissive_strength", pointer_);
    surface_.glow.radiance = color_of(source_.emissiveFactor) * strength.number("emissiveStrength", 1);
    if (max_component(surface_.glow.radiance) > max_radiance)
      inputs_.context.fail(pointer_ + "/emissiveFactor",
                           fmt::format("times its strength it is {:g}; valid are up to {:g}",
                                       max_component(surface_.glow.radiance), max_radiance));
    if (is_black(surface_.glow.radiance)) return;
    set_glow(slots_.emissive);
    // All of the surface would be as bright as its brightest part may be.
    if (slots_.emissive && inputs_.uv_set >= 0 && slots_.emissive.uv_set != inputs_.uv_set) {
      surface_.glow.radiance = {0, 0, 0};
      inputs_.context.warn(slots_.emissive.pointer, "the light of the surface is left out with its texture");
    }
  }

  void set_glow(const GltfSlot& slot) {
    if (!inputs_.can_use(slot)) return;
    const std::uint32_t texture =
        inputs_.textures.picture(slot, {PictureRole::color, PictureChannels::color});
    const auto* picture = std::get_if<ImageTexture>(&inputs_.textures.textures()[texture].model);
    if (!picture) return;
    surface_.glow.picture = std::make_shared<const Image>(picture->image->image(0));
    surface_.glow.uv = picture->uv;
    surface_.glow.wrap = picture->wrap;
    if (picture->filter == TextureFilter::nearest) surface_.glow.filter = TextureFilter::nearest;
  }

  const tinygltf::Material& source_;
  const std::string& pointer_;
  GltfInputs& inputs_;
  GltfSlots slots_;
  float opacity_ = 1;
  GltfSurface surface_;
};

}  // namespace

std::string material_pointer(int material) { return fmt::format("/materials/{}", material); }

std::optional<int> GltfMaterials::uv_set(int material) const {
  const tinygltf::Material& source = material_at(document_, material);
  for (const GltfSlot& slot : rendered_slots(source, material_pointer(material)))
    if (slot) return slot.uv_set;
  if (is_brushed(source)) return 0;
  return std::nullopt;
}

std::optional<int> GltfMaterials::second_uv_set(int material) const {
  const std::optional<int> first = uv_set(material);
  for (const GltfSlot& slot : input_slots(material_at(document_, material), material_pointer(material)))
    if (slot && slot.uv_set != first) return slot.uv_set;
  return std::nullopt;
}

std::set<int> GltfMaterials::uv_sets(int material) const {
  std::set<int> sets;
  for (const GltfSlot& slot : rendered_slots(material_at(document_, material), material_pointer(material)))
    if (slot) sets.insert(slot.uv_set);
  return sets;
}

bool GltfMaterials::needs_handedness(int material) const {
  const tinygltf::Material& source = material_at(document_, material);
  const GltfExtension anisotropy(source.extensions, "KHR_materials_anisotropy", "");
  return source.normalTexture.index >= 0 || anisotropy.slot("anisotropyTexture") ||
         anisotropy.number("anisotropyRotation", 0) != 0;
}

bool GltfMaterials::goes_by_tangents(int material) const {
  return needs_handedness(material) || is_brushed(material_at(document_, material));
}

bool GltfMaterials::is_unlit(int material) const {
  return bool(GltfExtension(material_at(document_, material).extensions, "KHR_materials_unlit", ""));
}

const GltfSurface& GltfMaterials::surface(int index, const GltfUse& use) {
  const auto [entry, is_new] = known_.try_emplace({index, use});
  if (!is_new) return entry->second;
  const tinygltf::Material& source = material_at(document_, index);
  const std::string pointer = material_pointer(index);
  GltfInputs inputs{textures, document_.context(), use.has_uvs ? uv_set(index).value_or(-1) : -1,
                    use.has_second_uvs ? second_uv_set(index).value_or(-1) : -1, use.is_mirrored};
  inputs.missing_sets = use.missing_sets;
  GltfSurface surface = MaterialReader(source, pointer, inputs).read(use);
  inputs.material.name = index < 0             ? "default"
                         : source.name.empty() ? fmt::format("material {}", index)
                                               : source.name;
  if (source.occlusionTexture.index >= 0 &&
      std::find(occluded.begin(), occluded.end(), inputs.material.name) == occluded.end())
    occluded.push_back(inputs.material.name);
  surface.material = std::uint32_t(materials.size());
  materials.push_back(std::move(inputs.material));
  return entry->second = std::move(surface);
}

}  // namespace twinray
