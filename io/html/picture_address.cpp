// SPDX-License-Identifier: Apache-2.0
#include "io/html/picture_address.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "io/lower_case.h"
#include "io/picture/png.h"

namespace twinray::html {
namespace {

/// The media type that browsers know a picture by.
std::string media_type(const std::string& path) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  if (ending == ".png" || ending == ".gif" || ending == ".webp") return "image/" + ending.substr(1);
  if (ending == ".jpg" || ending == ".jpeg") return "image/jpeg";
  throw Error(fmt::format("{}: not a picture for a page; valid endings are .png, .jpg, .gif, .webp", path));
}

std::string read(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error(fmt::format("{}: there is no such picture", path));
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw Error(fmt::format("{}: cannot be read", path));
  return bytes;
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) bits = bits << 8 | (j < count ? std::uint8_t(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += j <= count ? letters[bits >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::string picture_address(const std::string& path) {
  return fmt::format("data:{};base64,{}", media_type(path), base64(read(path)));
}

std::string picture_address(const ByteImage& image) {
  const std::vector<unsigned char> bytes = encode_png(image, {});
  return "data:image/png;base64," + base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace twinray::html
