// SPDX-License-Identifier: Apache-2.0
// What glTF 2.0 and the extensions that are read say of each property, as one table (Khronos Group, "glTF 2.0
// Specification", 2.0.1, chapter 5, and the extensions' own pages).
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace twinray {

enum class GltfKind {
  passed,   ///< Not read; anything.
  flag,     ///< true or false
  integer,  ///< least to most
  number,   ///< least to most
  text,
  word,     ///< One of the words of `of`.
  code,     ///< One of the whole numbers of `of`.
  index,    ///< Into the file's array `of`.
  object,   ///< By the rules of `of`.
  numbers,  ///< least_size to most_size numbers, each least to most
  indices,  ///< Into the file's array `of`, each once.
  texts,
  objects,   ///< An array of objects by the rules of `of`.
  accessors  ///< An object of any names, each an index of an accessor.
};

struct GltfRule {
  std::string_view object, property;
  GltfKind kind = GltfKind::passed;
  std::string_view of = {};
  double least = -3e38, most = 3e38;  ///< What a float holds.
  std::size_t least_size = 0, most_size = 0;
  bool is_required = false;
};

/// The rules of all kinds of objects; those of one stand together.
std::span<const GltfRule> gltf_rules();

/// Whether an extension is read, wherever it stands.
bool is_read_extension(std::string_view name);
/// Whether an extension that is read means something on an object of a kind of the rules.
bool may_have_extension(std::string_view object, std::string_view name);
/// What an extension that is read belongs to: "a material".
std::string_view owner_of_extension(std::string_view name);
/// The extension that is read whose name is nearest, as nearest_name says; "" where none is near.
std::string nearest_extension(std::string_view name);
/// Whether an extension says nothing of a picture, so that nobody misses it.
bool is_silent_extension(std::string_view name);

}  // namespace twinray
