// SPDX-License-Identifier: Apache-2.0
#include "io/network/tev_packets.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little);

enum class Operation : std::uint8_t { create_image = 4, update_image = 6 };

/// A packet as it grows; its length, which comes first and counts itself, is put in at the end.
class Packet {
 public:
  explicit Packet(Operation operation) : bytes_(sizeof(std::uint32_t), '\0') { add(operation); }

  template <class Number>
  void add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void add(const std::string& text) { bytes_.append(text.c_str(), text.size() + 1); }
  void add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(text);
  }
  void add(const float* values, std::size_t count) {
    bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(float));
  }
  std::string finish() {
    const auto length = std::uint32_t(bytes_.size());
    std::memcpy(bytes_.data(), &length, sizeof(length));
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

/// The viewer need not come to the front.
constexpr std::uint8_t keep_focus = 0;

}  // namespace

std::string create_packet(const ViewerPicture& picture) {
  Packet packet(Operation::create_image);
  packet.add(keep_focus);
  packet.add(picture.name);
  packet.add(std::int32_t(picture.width));
  packet.add(std::int32_t(picture.height));
  packet.add(std::int32_t(picture.channels.size()));
  packet.add(picture.channels);
  return packet.finish();
}

std::string update_packet(const ViewerPicture& picture, int y0, int y1) {
  const std::size_t channels = picture.channels.size(), row = std::size_t(picture.width) * channels;
  Packet packet(Operation::update_image);
  packet.add(keep_focus);
  packet.add(picture.name);
  packet.add(std::int32_t(channels));
  packet.add(picture.channels);
  for (const int value : {0, y0, picture.width, y1 - y0}) packet.add(std::int32_t(value));
  for (std::size_t channel = 0; channel < channels; ++channel) packet.add(std::int64_t(channel));   // offsets
  for (std::size_t channel = 0; channel < channels; ++channel) packet.add(std::int64_t(channels));  // strides
  packet.add(picture.values.data() + std::size_t(y0) * row, std::size_t(y1 - y0) * row);
  return packet.finish();
}

int rows_a_packet(const ViewerPicture& picture) {
  constexpr std::size_t bytes = 1'000'000;
  const std::size_t row = std::size_t(picture.width) * picture.channels.size() * sizeof(float);
  return int(std::max<std::size_t>(1, bytes / std::max<std::size_t>(1, row)));
}

}  // namespace twinray
