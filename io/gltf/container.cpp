// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/container.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;

/// 32 bits, the least significant first.
std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

class Chunks {
 public:
  Chunks(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

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
    return container;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(fmt::format("{}: not a binary glTF file: {}", name_, why));
  }

  void check_header() {
    if (bytes_.size() < header_bytes) fail(fmt::format("{} bytes are less than its header", bytes_.size()));
    const std::uint32_t version = word_at(bytes_, 4), length = word_at(bytes_, 8);
    if (version != 2) fail(fmt::format("its version is {}; valid is 2", version));
    if (length > bytes_.size())
      fail(fmt::format("its header says {} bytes, and the file ends after {}", length, bytes_.size()));
    bytes_ = bytes_.substr(0, length);
    offset_ = header_bytes;
  }

  std::uint32_t next_type() const { return word_at(bytes_, offset_ + 4); }

  std::string_view next() {
    const std::size_t length = word_at(bytes_, offset_), begin = offset_ + chunk_header_bytes;
    if (length > bytes_.size() - begin)
      fail(fmt::format("the chunk at byte {} says {} bytes, and the file ends after {}", offset_, length,
                       bytes_.size() - begin));
    offset_ = begin + length;
    return bytes_.substr(begin, length);
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t offset_ = 0;
};

}  // namespace

GltfContainer open_gltf(std::string bytes, const std::string& name) {
  if (bytes.compare(0, 4, "glTF") != 0) return {std::move(bytes), std::nullopt};
  return Chunks(bytes, name).read();
}

}  // namespace twinray
