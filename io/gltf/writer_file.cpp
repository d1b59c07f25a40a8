// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/writer_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/aabb.h"
#include "core/error.h"
#include "io/output_file.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr int most_exponent = 29;  // Readers may refuse more than 10^9.
constexpr int float_type = 5126, index_type = 5125;
constexpr int vertex_target = 34962, index_target = 34963;
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

template <typename Value>
std::string_view bytes_of(std::span<const Value> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// The bytes up to a multiple of four.
void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

void append_word(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

void append_chunk(std::string& bytes, std::uint32_t type, const std::string& chunk) {
  append_word(bytes, std::uint32_t(chunk.size()));
  append_word(bytes, type);
  bytes += chunk;
}

/// A file's name as a URI: all but letters, digits and a few marks by their codes.
std::string uri_of(const std::string& name) {
  std::string uri;
  for (const char c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '-' || c == '_' || c == '.' || c == '~';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

}  // namespace

GltfJson gltf_color(const Rgb& color) {
  return {shortest_decimal(color.r), shortest_decimal(color.g), shortest_decimal(color.b)};
}

GltfJson gltf_matrix(const Transform& transform) {
  GltfJson numbers = GltfJson::array();
  for (int column = 0; column < 4; ++column) {
    for (const auto& row : transform.m) numbers.push_back(row[column]);
    numbers.push_back(column < 3 ? 0.0 : 1.0);
  }
  return numbers;
}

GltfLight gltf_light(const Rgb& amount) {
  const float most = max_component(amount);
  if (!(most > 1)) return {amount, 1};
  int exponent = 0;
  std::frexp(most, &exponent);
  const float strength = std::ldexp(1.0f, std::min(exponent, most_exponent));
  return {amount / strength, strength};
}

std::size_t GltfFile::add(const char* list, const GltfJson& entry) {
  root_[list].push_back(entry);
  return root_[list].size() - 1;
}

void GltfFile::use(const std::string& extension) {
  GltfJson& used = root_["extensionsUsed"];
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

std::size_t GltfFile::add_view(std::string_view bytes, Use use) {
  pad(buffer_, '\0');
  GltfJson view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (use != Use::picture) view["target"] = use == Use::vertices ? vertex_target : index_target;
  buffer_ += bytes;
  return add("bufferViews", view);
}

std::size_t GltfFile::add_accessor(GltfJson accessor, std::string_view bytes, Use use) {
  accessor["bufferView"] = add_view(bytes, use);
  return add("accessors", accessor);
}

std::size_t GltfFile::vectors(std::span<const Vec3> values, bool has_bounds) {
  GltfJson accessor{{"componentType", float_type}, {"count", values.size()}, {"type", "VEC3"}};
  if (has_bounds) {
    Aabb box;
    for (const Vec3& value : values) box.extend(value);
    accessor["min"] = {double(box.lower.x), double(box.lower.y), double(box.lower.z)};
    accessor["max"] = {double(box.upper.x), double(box.upper.y), double(box.upper.z)};
  }
  return add_accessor(accessor, bytes_of(values), Use::vertices);
}

std::size_t GltfFile::pairs(std::span<const Vec2> values) {
  return add_accessor({{"componentType", float_type}, {"count", values.size()}, {"type", "VEC2"}},
                      bytes_of(values), Use::vertices);
}

std::size_t GltfFile::colors(std::span<const std::array<float, 4>> values) {
  return add_accessor({{"componentType", float_type}, {"count", values.size()}, {"type", "VEC4"}},
                      bytes_of(values), Use::vertices);
}

std::size_t GltfFile::indices(std::span<const std::uint32_t> values) {
  return add_accessor({{"componentType", index_type}, {"count", values.size()}, {"type", "SCALAR"}},
                      bytes_of(values), Use::corners);
}

std::size_t GltfFile::add_image(const std::string& name, std::string bytes) {
  const std::size_t number = root_.contains("images") ? root_["images"].size() : 0;
  GltfJson image = GltfJson::object();
  if (!name.empty()) image["name"] = name;
  if (is_binary_) {
    image["bufferView"] = add_view(bytes, Use::picture);
    image["mimeType"] = "image/png";
  } else {
    image["uri"] =
        uri_of(output.add(fmt::format("-texture-{}.png", number),
                          [bytes = std::move(bytes)](const std::string& path) { write_file(path, bytes); }));
  }
  return add("images", image);
}

/// Of one file: a header, and the chunks of the text and the buffer, each of a multiple of four bytes.
std::string GltfFile::packed() {
  std::string text = root_.dump(-1, ' ', false, GltfJson::error_handler_t::replace),
              buffer = std::move(buffer_);
  pad(text, ' ');
  pad(buffer, '\0');
  constexpr std::size_t header = 12, chunk_header = 8;
  const std::size_t size =
      header + chunk_header + text.size() + (buffer.empty() ? 0 : chunk_header + buffer.size());
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw Error(fmt::format("{}: a .glb file holds 4 GiB, and this scene needs {} bytes; write it as .gltf",
                            output.path(), size));
  std::string bytes;
  append_word(bytes, magic);
  append_word(bytes, version);
  append_word(bytes, std::uint32_t(size));
  append_chunk(bytes, json_chunk, text);
  if (!buffer.empty()) append_chunk(bytes, binary_chunk, buffer);
  return bytes;
}

WrittenScene GltfFile::finish() {
  root_["scene"] = 0;
  if (!root_.contains("scenes")) root_["scenes"] = GltfJson::array({GltfJson::object()});
  if (!buffer_.empty()) {
    GltfJson buffer{{"byteLength", buffer_.size()}};
    if (!is_binary_)
      buffer["uri"] = uri_of(output.add(
          ".bin", [bytes = std::move(buffer_)](const std::string& path) { write_file(path, bytes); }));
    root_["buffers"] = GltfJson::array({buffer});
  }
  return output.finish(is_binary_ ? packed()
                                  : root_.dump(1, ' ', false, GltfJson::error_handler_t::replace) + "\n");
}

}  // namespace twinray
