// SPDX-License-Identifier: Apache-2.0
// What a glTF material says of one of its textures, and the properties of its extensions.
#pragma once
#include <map>
#include <string>

#include "core/rgb.h"
#include "core/texture.h"

namespace tinygltf {
class Value;
struct Material;
}  // namespace tinygltf

namespace twinray {

/// A texture as a material uses it.
struct GltfSlot {
  int texture = -1;  ///< Index into the file's textures; -1: none.
  int uv_set = 0;    ///< The number of its TEXCOORD.
  UvTransform uv;    ///< Of KHR_texture_transform, for coordinates whose v runs upwards.
  float scale = 1;   ///< Of a normal map's x and y.
  std::string pointer;

  explicit operator bool() const { return texture >= 0; }
};

/// The slots that every material has.
struct GltfSlots {
  GltfSlot base_color, metallic_roughness, normal, occlusion, emissive;
};
GltfSlots slots_of(const tinygltf::Material& material, const std::string& pointer);

/// An extension of an object, whose properties' types were checked.
class GltfExtension {
 public:
  /// `pointer` is that of the object.
  GltfExtension(const std::map<std::string, tinygltf::Value>& extensions, const char* name,
                const std::string& pointer);

  /// Whether the object has it.
  explicit operator bool() const { return value_ != nullptr; }
  bool has(const char* property) const;
  bool flag(const char* property, bool otherwise) const;
  float number(const char* property, float otherwise) const;
  float component(const char* property, int index, float otherwise) const;
  Rgb color(const char* property, const Rgb& otherwise) const;
  GltfSlot slot(const char* property) const;
  const std::string& pointer() const { return pointer_; }

 private:
  const tinygltf::Value* value_ = nullptr;
  std::string pointer_;
};

}  // namespace twinray
