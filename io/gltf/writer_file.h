// SPDX-License-Identifier: Apache-2.0
// Private to the writer of glTF: the JSON text of a file that grows, and its one buffer.
#pragma once
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/rgb.h"
#include "core/transform.h"
#include "core/vec.h"
#include "io/decimal.h"
#include "io/written_scene.h"

namespace twinray {

/// Objects keep their order.
using GltfJson = nlohmann::ordered_json;

GltfJson gltf_color(const Rgb& color);
/// Column by column, as a node has it.
GltfJson gltf_matrix(const Transform& transform);

/// A colour of light as one whose components are at most 1, times a power of two: both are exact.
struct GltfLight {
  Rgb color;
  float strength = 1;  ///< 1 or above.
};
GltfLight gltf_light(const Rgb& amount);

class GltfFile {
 public:
  /// `is_binary`: all is in one file.
  GltfFile(SceneOutput& to, bool is_binary) : output(to), is_binary_(is_binary) {}

  /// Adds an entry to one of the file's lists, and gives its index.
  std::size_t add(const char* list, const GltfJson& entry);
  /// Says that the file uses an extension.
  void use(const std::string& extension);
  /// Gives the file as a whole an extension's properties.
  void set_extension(const char* name, const GltfJson& properties) { root_["extensions"][name] = properties; }
  /// Adds a node of the scene.
  void add_node(const GltfJson& node) { root_["scenes"][0]["nodes"].push_back(add("nodes", node)); }

  // Accessors of attributes and indices.
  std::size_t vectors(std::span<const Vec3> values, bool has_bounds);
  std::size_t pairs(std::span<const Vec2> values);
  /// Of four components each.
  std::size_t colors(std::span<const std::array<float, 4>> values);
  std::size_t indices(std::span<const std::uint32_t> values);

  /// A picture of PNG's bytes: in a file beside the scene, or in the buffer.
  std::size_t add_image(const std::string& name, std::string bytes);

  /// The whole, with the buffer beside it or within.
  WrittenScene finish();

  SceneOutput& output;

 private:
  enum class Use { vertices, corners, picture };
  std::size_t add_view(std::string_view bytes, Use use);
  std::size_t add_accessor(GltfJson accessor, std::string_view bytes, Use use);
  std::string packed();

  bool is_binary_;
  GltfJson root_{{"asset", {{"version", "2.0"}, {"generator", "twinray"}}}};
  std::string buffer_;
};

}  // namespace twinray
