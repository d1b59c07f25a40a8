// SPDX-License-Identifier: Apache-2.0
// glTF files in tests: JSON whose arrays grow by small functions, with one buffer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.h"
#include "io/gltf/gltf.h"
#include "tests/support/json.h"

namespace twinray::test {

/// The code that glTF has for a type of numbers.
template <typename Number>
constexpr int component_type() {
  if constexpr (std::is_same_v<Number, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<Number, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<Number, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return 5125;
  return 5126;
}

inline std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

struct GltfFile {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  /// Adds to one of the file's arrays, and gives the index.
  int add(const char* array, const nlohmann::json& element) {
    json[array].push_back(element);
    return int(json[array].size()) - 1;
  }
  /// A buffer view of these bytes, at a multiple of four.
  int view(const std::string& bytes) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    const std::size_t offset = buffer.size();
    buffer += bytes;
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
  }
  template <typename Number>
  int accessor(const std::vector<Number>& numbers, const std::string& type, bool is_normalized = false) {
    const std::size_t components = type == "SCALAR" ? 1
                                   : type == "MAT4" ? 16
                                                    : std::size_t(type.back() - '0');
    nlohmann::json made = {{"bufferView", view(bytes_of(numbers))},
                           {"componentType", component_type<Number>()},
                           {"count", numbers.size() / components},
                           {"type", type}};
    if (is_normalized) made["normalized"] = true;
    return add("accessors", made);
  }
  /// A node of the scene that shows a mesh of one primitive.
  int show(const nlohmann::json& primitive) {
    const int mesh = add("meshes", {{"primitives", {primitive}}});
    return add_node({{"mesh", mesh}});
  }
  int add_node(const nlohmann::json& node) {
    const int index = add("nodes", node);
    if (!json.contains("scenes")) json["scenes"] = {{{"nodes", nlohmann::json::array()}}};
    json["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  nlohmann::json& primitive(int mesh = 0) { return json["meshes"][std::size_t(mesh)]["primitives"][0]; }

  /// As the text of a .gltf file, with its buffer in it.
  std::string text() const {
    nlohmann::json whole = json;
    if (!buffer.empty())
      whole["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    return whole.dump();
  }
  LoadedScene load(const LoadOptions& options = {}) const { return read_gltf(text(), "test.gltf", options); }
  /// What loading it fails with; empty where it does not.
  std::string error(const LoadOptions& options = {}) const {
    try {
      load(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  /// The only warning; empty where there is none, "several" where there are more.
  std::string warning() const {
    const auto warnings = load().warnings;
    return warnings.empty() ? "" : warnings.size() > 1 ? "several" : warnings[0].text();
  }
};

/// A triangle in the plane z = 0 whose normal is +z.
inline GltfFile gltf_triangle() {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  file.show({{"attributes", {{"POSITION", positions}}}});
  return file;
}

/// The same with texture coordinates, and a material that has these properties.
inline GltfFile gltf_surface(const nlohmann::json& material) {
  GltfFile file = gltf_triangle();
  file.primitive()["attributes"]["TEXCOORD_0"] = file.accessor<float>({0, 1, 1, 1, 0, 0}, "VEC2");
  file.primitive()["material"] = file.add("materials", material);
  return file;
}

inline const Mesh& only_mesh(const LoadedScene& loaded) { return *loaded.scene.geometry->mesh(0); }

/// What reading these bytes of "test.glb" fails with; empty where it does not.
inline std::string glb_error(const std::string& bytes) {
  try {
    read_gltf(bytes, "test.glb");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace twinray::test
