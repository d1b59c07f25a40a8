// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/slot.h"

#include <tiny_gltf.h>

#include <cmath>

#include "core/elementary.h"

namespace twinray {
namespace {

const tinygltf::Value* find(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

double number_in(const tinygltf::Value& object, const char* property, std::size_t index, double otherwise) {
  return object.Has(property) ? object.Get(property).Get(int(index)).GetNumberAsDouble() : otherwise;
}

/// KHR_texture_transform: offset + R S (u, v), where R turns counter-clockwise in coordinates whose v runs
/// downwards. Ours are (u, 1 - v) on both sides of it.
UvTransform uv_transform(const tinygltf::Value& value) {
  const double x = number_in(value, "offset", 0, 0), y = number_in(value, "offset", 1, 0);
  const double sx = number_in(value, "scale", 0, 1), sy = number_in(value, "scale", 1, 1);
  const double angle = value.Has("rotation") ? value.Get("rotation").GetNumberAsDouble() : 0;
  const double s = sin_radians(angle), c = cos_radians(angle);
  return {{{float(c * sx), float(-s * sy), float(s * sy + x)},
           {float(s * sx), float(c * sy), float(1 - c * sy - y)}}};
}

void apply_transform(GltfSlot& slot, const tinygltf::ExtensionMap& extensions) {
  const tinygltf::Value* transform = find(extensions, "KHR_texture_transform");
  if (!transform) return;
  slot.uv = uv_transform(*transform);
  if (transform->Has("texCoord")) slot.uv_set = transform->Get("texCoord").GetNumberAsInt();
}

template <typename Info>
GltfSlot slot_of(const Info& info, std::string pointer) {
  GltfSlot slot{info.index, info.texCoord, {}, 1, std::move(pointer)};
  if constexpr (requires { info.scale; }) slot.scale = float(info.scale);
  apply_transform(slot, info.extensions);
  return slot;
}

}  // namespace

GltfSlots slots_of(const tinygltf::Material& material, const std::string& pointer) {
  const auto& metallic = material.pbrMetallicRoughness;
  const std::string within = pointer + "/pbrMetallicRoughness";
  return {slot_of(metallic.baseColorTexture, within + "/baseColorTexture"),
          slot_of(metallic.metallicRoughnessTexture, within + "/metallicRoughnessTexture"),
          slot_of(material.normalTexture, pointer + "/normalTexture"),
          slot_of(material.occlusionTexture, pointer + "/occlusionTexture"),
          slot_of(material.emissiveTexture, pointer + "/emissiveTexture")};
}

GltfExtension::GltfExtension(const std::map<std::string, tinygltf::Value>& extensions, const char* name,
                             const std::string& pointer)
    : value_(find(extensions, name)), pointer_(pointer + "/extensions/" + name) {}

bool GltfExtension::has(const char* property) const { return value_ && value_->Has(property); }

bool GltfExtension::flag(const char* property, bool otherwise) const {
  return has(property) ? value_->Get(property).Get<bool>() : otherwise;
}

float GltfExtension::number(const char* property, float otherwise) const {
  return has(property) ? float(value_->Get(property).GetNumberAsDouble()) : otherwise;
}

float GltfExtension::component(const char* property, int index, float otherwise) const {
  return has(property) ? float(value_->Get(property).Get(index).GetNumberAsDouble()) : otherwise;
}

Rgb GltfExtension::color(const char* property, const Rgb& otherwise) const {
  return {component(property, 0, otherwise.r), component(property, 1, otherwise.g),
          component(property, 2, otherwise.b)};
}

GltfSlot GltfExtension::slot(const char* property) const {
  if (!has(property)) return {};
  const tinygltf::Value& info = value_->Get(property);
  GltfSlot slot;
  slot.texture = info.Get("index").GetNumberAsInt();
  if (info.Has("texCoord")) slot.uv_set = info.Get("texCoord").GetNumberAsInt();
  slot.pointer = pointer_ + "/" + property;
  const bool has_transform = info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform");
  if (!has_transform) return slot;
  const tinygltf::Value& transform = info.Get("extensions").Get("KHR_texture_transform");
  slot.uv = uv_transform(transform);
  if (transform.Has("texCoord")) slot.uv_set = transform.Get("texCoord").GetNumberAsInt();
  return slot;
}

}  // namespace twinray
