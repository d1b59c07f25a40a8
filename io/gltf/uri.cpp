// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/uri.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "io/uri.h"

namespace twinray {
namespace {

constexpr std::string_view scheme = "data:", marker = ";base64";

constexpr std::uint8_t no_letter = 255, blank = 254;

/// The value of each letter of base64 (and of its variant for URIs), and of what lies between its lines.
constexpr std::array<std::uint8_t, 256> base64_values() {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  values.fill(no_letter);
  for (const char between : {' ', '\t', '\n', '\r'}) values[static_cast<unsigned char>(between)] = blank;
  for (std::size_t i = 0; i < letters.size(); ++i)
    values[static_cast<unsigned char>(letters[i])] = std::uint8_t(i);
  values['-'] = 62, values['_'] = 63;
  return values;
}

std::string decode_base64(std::string_view text, const std::string& pointer, const GltfContext& context) {
  constexpr auto values = base64_values();
  while (!text.empty() && (text.back() == '=' || values[static_cast<unsigned char>(text.back())] == blank))
    text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const std::uint32_t value = values[static_cast<unsigned char>(letter)];
    if (value == blank) continue;
    if (value == no_letter) context.fail(pointer, "the data URI holds a character that is none of base64's");
    bits = bits << 6 | value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(char(bits >> count));
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.substr(0, scheme.size()) == scheme; }

std::string data_of_uri(std::string_view uri, const std::string& pointer, const GltfContext& context) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) context.fail(pointer, "the data URI has no comma before its data");
  const std::string_view kind = uri.substr(0, comma), data = uri.substr(comma + 1);
  const bool is_base64 = kind.size() >= marker.size() && kind.substr(kind.size() - marker.size()) == marker;
  return is_base64 ? decode_base64(data, pointer, context) : decoded_uri(data);
}

std::string remote_fault(const std::string& uri) {
  return fmt::format("\"{}\" lies on another machine; files of this one are read", uri);
}

std::string gltf_path(const std::string& uri, const std::string& pointer, const GltfContext& context) {
  if (is_remote(uri)) context.fail(pointer, remote_fault(uri));
  return path_of_uri(uri, context.file);
}

std::string bytes_of_uri(const std::string& uri, const std::string& pointer, const GltfContext& context) {
  if (is_data_uri(uri)) return data_of_uri(uri, pointer, context);
  const std::string path = gltf_path(uri, pointer, context);
  context.options.add_file(path);
  try {
    return context.read(path);
  } catch (const Error& error) {
    context.fail(pointer, error.what());
  }
}

}  // namespace twinray
