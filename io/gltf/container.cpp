// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "io/gltf/context.h"

namespace twinray {
namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
constexpr std::string_view magic = "glTF";
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;

/// 32 bits, the least significant first.
std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

class Chunks {
 public:
  Chunks(std::string_view bytes, GltfContext& context) : bytes_(bytes), context_(context) {}

  GltfContainer read() {
    check_header();
    GltfContainer container;
    if (bytes_.size() < header_bytes + chunk_header_bytes || next_type() != json_chunk)
      fail("the first chunk must be the JSON one");
    container.json = next();
    // The chunk ends at a multiple of 4 bytes, as do those that follow; what is unknown is passed over.
    while (offset_ + chunk_header_bytes <= bytes_.size()) {
      const bool is_buffer = next_type() == binary_chunk;
      const std::string_view chunk = next();
      if (is_buffer && !container.buffer) container.buffer = chunk;
    }
    check_end();
    return container;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(fmt::format("{}: not a binary glTF file: {}", context_.file, why));
  }

  void check_header() {
    if (bytes_.size() < header_bytes) fail(fmt::format("{} bytes are less than its header", bytes_.size()));
    if (!bytes_.starts_with(magic))
      fail(fmt::format("its first bytes are {:02x}; valid are {:02x}, \"{}\"",
                       fmt::join(first_bytes(bytes_), " "), fmt::join(first_bytes(magic), " "), magic));
    const std::uint32_t version = word_at(bytes_, 4), length = word_at(bytes_, 8);
    if (version != 2) fail(fmt::format("its version is {}; valid is 2", version));
    if (length > bytes_.size())
      fail(fmt::format("its header says {} bytes, and the file ends after {}", length, bytes_.size()));
    if (length < header_bytes + chunk_header_bytes)
      fail(fmt::format("its header says {} bytes, which are too few for a chunk; the file has {}", length,
                       bytes_.size()));
    if (length < bytes_.size())
      context_.warn("/",
                    fmt::format("the header of this binary file says {} bytes; the {} behind them are not "
                                "read",
                                length, bytes_.size() - length));
    file_bytes_ = bytes_.size();
    bytes_ = bytes_.substr(0, length);
    offset_ = header_bytes;
  }

  static std::array<unsigned, 4> first_bytes(std::string_view bytes) {
    std::array<unsigned, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<unsigned char>(bytes[i]);
    return values;
  }

  /// Fewer than 4 bytes are what aligns the last chunk's end.
  void check_end() const {
    const std::size_t rest = bytes_.size() - offset_;
    if (rest >= 4)
      fail(fmt::format("the chunk at byte {} is cut: of its header of {} bytes there are {}", offset_,
                       chunk_header_bytes, rest));
  }

  std::uint32_t next_type() const { return word_at(bytes_, offset_ + 4); }

  std::string_view next() {
    const std::size_t length = word_at(bytes_, offset_), begin = offset_ + chunk_header_bytes;
    if (length > bytes_.size() - begin && bytes_.size() < file_bytes_)
      fail(fmt::format(
          "the chunk at byte {} says {} bytes, and the file's header, which says {} in all, leaves "
          "it {}",
          offset_, length, bytes_.size(), bytes_.size() - begin));
    if (length > bytes_.size() - begin)
      fail(fmt::format("the chunk at byte {} says {} bytes, and the file ends after {}", offset_, length,
                       bytes_.size() - begin));
    offset_ = begin + length;
    return bytes_.substr(begin, length);
  }

  std::string_view bytes_;
  GltfContext& context_;
  std::size_t offset_ = 0, file_bytes_ = 0;
};

/// In letters of either size.
bool is_glb(std::string_view ending) {
  constexpr std::string_view glb = ".glb";
  return std::equal(ending.begin(), ending.end(), glb.begin(), glb.end(),
                    [](char a, char b) { return a == b || (b != '.' && a == char(b - 'a' + 'A')); });
}

/// Whether a file is meant as a binary one, whatever is wrong with it.
bool is_binary(std::string_view bytes, std::string_view name) {
  if (bytes.starts_with(magic)) return true;
  constexpr std::string_view begins_json = "{[\" \t\r\n\xef";
  const bool is_named = name.size() >= 4 && is_glb(name.substr(name.size() - 4));
  return is_named && !bytes.empty() && begins_json.find(bytes[0]) == std::string_view::npos;
}

}  // namespace

GltfContainer open_gltf(std::string bytes, GltfContext& context) {
  if (!is_binary(bytes, context.file)) return {std::move(bytes), std::nullopt};
  return Chunks(bytes, context).read();
}

}  // namespace twinray
