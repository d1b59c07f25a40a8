// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "io/diagnostic.h"

namespace twinray {
namespace {

using enum GltfKind;

constexpr double most_size = 9007199254740992.0;  // 2^53, up to which JSON's numbers are whole
constexpr double most_count = 4294967295.0;
constexpr double most_int = 2147483647.0;  // what tinygltf keeps of extensions' numbers
constexpr std::string_view component_types = "5120 5121 5122 5123 5125 5126";

constexpr GltfRule object_rule(std::string_view object, std::string_view property, std::string_view of) {
  return {object, property, GltfKind::object, of};
}
constexpr GltfRule list(std::string_view property, std::string_view of) {
  return {"", property, objects, of};
}
constexpr GltfRule index_rule(std::string_view object, std::string_view property, std::string_view of) {
  return {object, property, index, of};
}
constexpr GltfRule unit(std::string_view object, std::string_view property) {
  return {object, property, number, "", 0, 1};
}
constexpr GltfRule positive(std::string_view object, std::string_view property) {
  return {object, property, number, "", 0};
}
constexpr GltfRule vector(std::string_view object, std::string_view property, std::size_t size) {
  return {object, property, numbers, "", -3e38, 3e38, size, size};
}
constexpr GltfRule color(std::string_view object, std::string_view property, double most) {
  return {object, property, numbers, "", 0, most, 3, 3};
}
constexpr GltfRule texture(std::string_view object, std::string_view property) {
  return {object, property, GltfKind::object, "textureInfo"};
}
constexpr GltfRule needed(GltfRule rule) {
  rule.is_required = true;
  return rule;
}

constexpr GltfRule rules[] = {
    // The file as a whole has the object "".
    needed(object_rule("", "asset", "asset")),
    {"", "extensionsUsed", texts},
    {"", "extensionsRequired", texts},
    list("accessors", "accessor"),
    list("animations", "animation"),
    list("buffers", "buffer"),
    list("bufferViews", "bufferView"),
    list("cameras", "camera"),
    list("images", "image"),
    list("materials", "material"),
    list("meshes", "mesh"),
    list("nodes", "node"),
    list("samplers", "sampler"),
    list("scenes", "scene"),
    list("skins", "skin"),
    list("textures", "texture"),
    index_rule("", "scene", "scenes"),

    needed({"asset", "version", text}),
    {"asset", "minVersion", text},
    {"asset", "generator"},
    {"asset", "copyright"},

    needed({"buffer", "byteLength", integer, "", 1, most_size}),
    {"buffer", "uri", text},
    needed(index_rule("bufferView", "buffer", "buffers")),
    {"bufferView", "byteOffset", integer, "", 0, most_size},
    needed({"bufferView", "byteLength", integer, "", 1, most_size}),
    {"bufferView", "byteStride", integer, "", 4, 252},
    {"bufferView", "target"},
    needed(index_rule("EXT_meshopt_compression", "buffer", "buffers")),
    {"EXT_meshopt_compression", "byteOffset", integer, "", 0, most_int},
    needed({"EXT_meshopt_compression", "byteLength", integer, "", 1, most_int}),
    needed({"EXT_meshopt_compression", "byteStride", integer, "", 1, 256}),
    needed({"EXT_meshopt_compression", "count", integer, "", 1, most_int}),
    needed({"EXT_meshopt_compression", "mode", word, "ATTRIBUTES TRIANGLES INDICES"}),
    {"EXT_meshopt_compression", "filter", word, "NONE OCTAHEDRAL QUATERNION EXPONENTIAL"},
    {"EXT_meshopt_compression of a buffer", "fallback", flag},

    index_rule("accessor", "bufferView", "bufferViews"),
    {"accessor", "byteOffset", integer, "", 0, most_size},
    needed({"accessor", "componentType", code, component_types}),
    {"accessor", "normalized", flag},
    needed({"accessor", "count", integer, "", 1, most_count}),
    needed({"accessor", "type", word, "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"}),
    {"accessor", "max"},
    {"accessor", "min"},
    object_rule("accessor", "sparse", "sparse"),
    needed({"sparse", "count", integer, "", 1, most_int}),
    needed(object_rule("sparse", "indices", "sparseIndices")),
    needed(object_rule("sparse", "values", "sparseValues")),
    needed(index_rule("sparseIndices", "bufferView", "bufferViews")),
    {"sparseIndices", "byteOffset", integer, "", 0, most_int},
    needed({"sparseIndices", "componentType", code, "5121 5123 5125"}),
    needed(index_rule("sparseValues", "bufferView", "bufferViews")),
    {"sparseValues", "byteOffset", integer, "", 0, most_int},

    needed({"mesh", "primitives", objects, "primitive", 0, 0, 1}),
    {"mesh", "weights", numbers, "", -3e38, 3e38, 0, 65536},
    needed({"primitive", "attributes", accessors}),
    index_rule("primitive", "indices", "accessors"),
    index_rule("primitive", "material", "materials"),
    {"primitive", "mode", code, "0 1 2 3 4 5 6"},
    {"primitive", "targets", objects, "target"},
    needed(index_rule("KHR_draco_mesh_compression", "bufferView", "bufferViews")),
    needed({"KHR_draco_mesh_compression", "attributes", GltfKind::object, "dracoAttributes"}),

    {"node", "name", text},
    index_rule("node", "camera", "cameras"),
    {"node", "children", indices, "nodes"},
    {"node", "matrix", numbers, "", -1e30, 1e30, 16, 16},
    index_rule("node", "mesh", "meshes"),
    vector("node", "rotation", 4),
    {"node", "scale", numbers, "", -1e30, 1e30, 3, 3},
    index_rule("node", "skin", "skins"),
    {"node", "translation", numbers, "", -1e30, 1e30, 3, 3},
    {"node", "weights", numbers, "", -3e38, 3e38, 0, 65536},
    {"KHR_node_visibility", "visible", flag},
    needed({"EXT_mesh_gpu_instancing", "attributes", accessors}),
    {"scene", "nodes", indices, "nodes"},
    index_rule("skin", "inverseBindMatrices", "accessors"),
    index_rule("skin", "skeleton", "nodes"),
    needed({"skin", "joints", indices, "nodes", 0, 0, 1}),

    needed({"camera", "type", word, "perspective orthographic"}),
    object_rule("camera", "perspective", "perspective"),
    object_rule("camera", "orthographic", "orthographic"),
    {"perspective", "aspectRatio", number, "", 1e-4, 1e4},
    needed({"perspective", "yfov", number, "", 1e-5, 3.14159}),
    {"perspective", "zfar", number, "", 0, 1e30},
    needed({"perspective", "znear", number, "", 0, 1e30}),
    needed({"orthographic", "xmag", number, "", -1e12, 1e12}),
    needed({"orthographic", "ymag", number, "", -1e12, 1e12}),
    needed({"orthographic", "zfar", number, "", 0, 1e30}),
    needed({"orthographic", "znear", number, "", 0, 1e30}),

    needed({"KHR_lights_punctual", "lights", objects, "light"}),
    needed({"KHR_lights_punctual of a node", "light", integer, "", 0, most_int}),
    needed({"light", "type", word, "directional point spot"}),
    color("light", "color", 1e9),
    {"light", "intensity", number, "", 0, 1e9},
    positive("light", "range"),
    object_rule("light", "spot", "spot"),
    {"spot", "innerConeAngle", number, "", 0, 1.5707964},
    {"spot", "outerConeAngle", number, "", 0, 1.5707964},

    needed({"animation", "channels", objects, "channel"}),
    needed({"animation", "samplers", objects, "animationSampler"}),
    needed({"channel", "sampler", integer, "", 0, most_int}),
    needed(object_rule("channel", "target", "channelTarget")),
    index_rule("channelTarget", "node", "nodes"),
    needed({"channelTarget", "path", text}),
    needed(index_rule("animationSampler", "input", "accessors")),
    needed(index_rule("animationSampler", "output", "accessors")),
    {"animationSampler", "interpolation", word, "LINEAR STEP CUBICSPLINE"},

    {"image", "uri", text},
    {"image", "mimeType"},
    index_rule("image", "bufferView", "bufferViews"),
    {"sampler", "magFilter", code, "9728 9729"},
    {"sampler", "minFilter", code, "9728 9729 9984 9985 9986 9987"},
    {"sampler", "wrapS", code, "33071 33648 10497"},
    {"sampler", "wrapT", code, "33071 33648 10497"},
    index_rule("texture", "sampler", "samplers"),
    index_rule("texture", "source", "images"),
    index_rule("EXT_texture_webp", "source", "images"),
    needed(index_rule("textureInfo", "index", "textures")),
    {"textureInfo", "texCoord", integer, "", 0, 255},
    {"textureInfo", "scale", number},
    unit("textureInfo", "strength"),
    vector("KHR_texture_transform", "offset", 2),
    {"KHR_texture_transform", "rotation", number, "", -1e4, 1e4},
    vector("KHR_texture_transform", "scale", 2),
    {"KHR_texture_transform", "texCoord", integer, "", 0, 255},

    object_rule("material", "pbrMetallicRoughness", "metallicRoughness"),
    texture("material", "normalTexture"),
    texture("material", "occlusionTexture"),
    texture("material", "emissiveTexture"),
    color("material", "emissiveFactor", 1e9),
    {"material", "alphaMode", word, "OPAQUE MASK BLEND"},
    positive("material", "alphaCutoff"),
    {"material", "doubleSided", flag},
    {"metallicRoughness", "baseColorFactor", numbers, "", 0, 1, 4, 4},
    texture("metallicRoughness", "baseColorTexture"),
    unit("metallicRoughness", "metallicFactor"),
    unit("metallicRoughness", "roughnessFactor"),
    texture("metallicRoughness", "metallicRoughnessTexture"),

    {"KHR_materials_emissive_strength", "emissiveStrength", number, "", 0, 1e9},
    {"KHR_materials_ior", "ior", number, "", 0, 1000},
    unit("KHR_materials_transmission", "transmissionFactor"),
    texture("KHR_materials_transmission", "transmissionTexture"),
    positive("KHR_materials_volume", "thicknessFactor"),
    texture("KHR_materials_volume", "thicknessTexture"),
    {"KHR_materials_volume", "attenuationDistance", number, "", 1e-30, 3e38},
    color("KHR_materials_volume", "attenuationColor", 1),
    unit("KHR_materials_clearcoat", "clearcoatFactor"),
    texture("KHR_materials_clearcoat", "clearcoatTexture"),
    unit("KHR_materials_clearcoat", "clearcoatRoughnessFactor"),
    texture("KHR_materials_clearcoat", "clearcoatRoughnessTexture"),
    texture("KHR_materials_clearcoat", "clearcoatNormalTexture"),
    color("KHR_materials_sheen", "sheenColorFactor", 1),
    texture("KHR_materials_sheen", "sheenColorTexture"),
    unit("KHR_materials_sheen", "sheenRoughnessFactor"),
    texture("KHR_materials_sheen", "sheenRoughnessTexture"),
    unit("KHR_materials_specular", "specularFactor"),
    texture("KHR_materials_specular", "specularTexture"),
    color("KHR_materials_specular", "specularColorFactor", 1e9),
    texture("KHR_materials_specular", "specularColorTexture"),
    {"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", numbers, "", 0, 1, 4, 4},
    texture("KHR_materials_pbrSpecularGlossiness", "diffuseTexture"),
    color("KHR_materials_pbrSpecularGlossiness", "specularFactor", 1),
    unit("KHR_materials_pbrSpecularGlossiness", "glossinessFactor"),
    texture("KHR_materials_pbrSpecularGlossiness", "specularGlossinessTexture"),
    unit("KHR_materials_anisotropy", "anisotropyStrength"),
    {"KHR_materials_anisotropy", "anisotropyRotation", number, "", -1e4, 1e4},
    texture("KHR_materials_anisotropy", "anisotropyTexture"),
    unit("KHR_materials_iridescence", "iridescenceFactor"),
    texture("KHR_materials_iridescence", "iridescenceTexture"),
    {"KHR_materials_iridescence", "iridescenceIor", number, "", 1, 100},
    {"KHR_materials_iridescence", "iridescenceThicknessMinimum", number, "", 0, 1e6},
    {"KHR_materials_iridescence", "iridescenceThicknessMaximum", number, "", 0, 1e6},
    texture("KHR_materials_iridescence", "iridescenceThicknessTexture"),
};

struct ReadExtension {
  std::string_view name, owners;  ///< Kinds of objects between spaces; "file" is the file as a whole.
  std::string_view belongs_to = "a material";
};

constexpr std::string_view file_or_node = "the file as a whole, and to a node";
/// Extensions without properties that are read, too; of one without an object the owners are "".
constexpr ReadExtension read_extensions[] = {
    {"EXT_mesh_gpu_instancing", "node", "a node"},
    {"EXT_meshopt_compression", "bufferView buffer", "a buffer view, and to a buffer"},
    {"EXT_texture_webp", "texture", "a texture"},
    {"KHR_draco_mesh_compression", "primitive", "a primitive of a mesh"},
    {"KHR_lights_punctual", "file node", file_or_node},
    {"KHR_materials_anisotropy", "material"},
    {"KHR_materials_clearcoat", "material"},
    {"KHR_materials_emissive_strength", "material"},
    {"KHR_materials_iridescence", "material"},
    {"KHR_materials_ior", "material"},
    {"KHR_materials_pbrSpecularGlossiness", "material"},
    {"KHR_materials_sheen", "material"},
    {"KHR_materials_specular", "material"},
    {"KHR_materials_transmission", "material"},
    {"KHR_materials_unlit", "material"},
    {"KHR_materials_volume", "material"},
    {"KHR_mesh_quantization", "", "\"extensionsUsed\" alone"},
    {"KHR_node_visibility", "node", "a node"},
    {"KHR_texture_transform", "textureInfo", "what names a texture, such as \"baseColorTexture\""}};

const ReadExtension* find_extension(std::string_view name) {
  const auto found = std::find_if(std::begin(read_extensions), std::end(read_extensions),
                                  [&](const ReadExtension& each) { return each.name == name; });
  return found == std::end(read_extensions) ? nullptr : &*found;
}

/// Two names without the beginning and the end that they share, but for a letter each.
std::pair<std::string_view, std::string_view> parts_apart(std::string_view a, std::string_view b) {
  const auto beginning = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
  const auto first = std::size_t(std::max<std::ptrdiff_t>(beginning - 1, 0));
  a.remove_prefix(first), b.remove_prefix(first);
  while (a.size() > 1 && b.size() > 1 && a.back() == b.back()) a.remove_suffix(1), b.remove_suffix(1);
  return {a, b};
}

constexpr std::array<std::string_view, 5> silent_extensions{"KHR_xmp", "KHR_xmp_json_ld", "MSFT_lod",
                                                            "EXT_mesh_manifold", "KHR_materials_variants"};

}  // namespace

std::span<const GltfRule> gltf_rules() { return rules; }

bool is_read_extension(std::string_view name) { return find_extension(name) != nullptr; }

bool may_have_extension(std::string_view object, std::string_view name) {
  const ReadExtension* const extension = find_extension(name);
  if (!extension) return false;
  const std::string_view kind = object.empty() ? "file" : object;
  return fmt::format(" {} ", extension->owners).find(fmt::format(" {} ", kind)) != std::string::npos;
}

std::string_view owner_of_extension(std::string_view name) { return find_extension(name)->belongs_to; }

std::string nearest_extension(std::string_view name) {
  std::vector<std::string_view> names;
  for (const ReadExtension& each : read_extensions) names.push_back(each.name);
  const std::string nearest = nearest_name(name, names);
  const auto [own, its] = parts_apart(name, nearest);
  return nearest_name(own, {&its, 1}).empty() ? "" : nearest;
}

bool is_silent_extension(std::string_view name) {
  return std::find(silent_extensions.begin(), silent_extensions.end(), name) != silent_extensions.end();
}

}  // namespace twinray
