// SPDX-License-Identifier: Apache-2.0
// Private: the numbers, colours and words of the exchange form.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

#include "core/light.h"
#include "core/material.h"
#include "core/vec.h"
#include "io/exchange/members.h"
#include "io/exchange/words.h"

namespace twinray {

/// Objects keep their order.
using Json = nlohmann::ordered_json;

/// A double whose digits are the shortest that tell the float from every other.
Json json_of(float number);
Json json_of(const Vec2& v);
Json json_of(const Vec3& v);
Json json_of(const Rgb& color);
Json json_of(const Roughness& roughness);
/// A value of one of the sets in io/exchange/words.h.
template <typename Word>
requires std::is_enum_v<Word> Json json_of(Word word) {
  for (const auto& [name, value] : words<Word>())
    if (value == word) return name;
  return nullptr;
}
/// The columns of a rotation, with all their digits: where the axes of the picture's space point to.
Json json_of(const Transform& rotation);
Json json_of(const Attenuation& attenuation);
/// One word, or a list of that of u and that of v.
Json json_of(const Wrap& wrap);
/// Its two rows.
Json json_of(const UvTransform& uv);
Json json_of(const PointTransform& map);
inline Json json_of(std::uint32_t index) { return index; }
inline Json json_of(std::int32_t number) { return number; }
inline Json json_of(bool flag) { return flag; }

/// Writes members into an object.
class MemberWriter {
 public:
  explicit MemberWriter(Json& object) : object_(object) {}

  template <typename Member>
  void operator()(const char* key, const Member& member, Valid = Valid::any) const {
    object_[key] = json_of(member);
  }
  void direction(const char* key, const Vec3& member) const { object_[key] = json_of(member); }
  template <typename Member>
  void later(const char* key, const Member& member, Valid = Valid::any) const {
    object_[key] = json_of(member);
  }
  void constant(const char* key, const char* word) const { object_[key] = word; }

 private:
  Json& object_;
};

/// An object of the type and the members of a material's model or a light's source.
template <typename Described>
Json described(Described value) {
  Json object{{"type", type_name(value)}};
  members(MemberWriter(object), value);
  return object;
}

/// The files that stand beside the JSON file of this path, by the numbers of shape, light, texture and so on.
std::string exchange_mesh_file(const std::string& path, std::size_t shape);
std::string exchange_light_file(const std::string& path, std::size_t light);
std::string exchange_texture_file(const std::string& path, std::size_t texture);
std::string exchange_density_file(const std::string& path, std::size_t density);
std::string exchange_brdf_file(const std::string& path, std::size_t material);

}  // namespace twinray
