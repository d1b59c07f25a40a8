// SPDX-License-Identifier: Apache-2.0
#include "tests/support/layered_exr.h"

#include <cstdint>

namespace twinray::test {
namespace {

template <class Number>
void add(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void add_text(std::string& bytes, const std::string& text) { bytes.append(text.c_str(), text.size() + 1); }

void add_attribute(std::string& header, const std::string& name, const std::string& type,
                   const std::string& value) {
  add_text(header, name);
  add_text(header, type);
  add(header, std::int32_t(value.size()));
  header += value;
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
  std::string bytes;
  for (const Number number : numbers) add(bytes, number);
  return bytes;
}

/// How many pixels of a row share a value.
int sampling(const std::vector<float>& values, int width, int height) {
  return values.size() < std::size_t(width * height) ? 2 : 1;
}

/// Name, type (2: float), linearity and sampling of each.
std::string channel_list(int width, int height, const Channels& channels) {
  std::string list;
  for (const auto& [name, values] : channels) {
    const int step = sampling(values, width, height);
    add_text(list, name);
    for (const int number : {2, 0, step, step}) add(list, std::int32_t(number));
  }
  return list + '\0';
}

std::string window(int x, int y, int width, int height) {
  return bytes_of<std::int32_t>({x, y, x + width - 1, y + height - 1});
}

std::string attributes_of(int width, int height, const Channels& channels, const ExrHeader& stated) {
  std::string header;
  add_attribute(header, "channels", "chlist", channel_list(width, height, channels));
  add_attribute(header, "compression", "compression", std::string(1, '\0'));
  add_attribute(header, "dataWindow", "box2i", window(stated.x, stated.y, width, height));
  add_attribute(header, "displayWindow", "box2i", window(stated.frame_x, stated.frame_y, width, height));
  add_attribute(header, "lineOrder", "lineOrder", std::string(1, '\0'));
  add_attribute(header, "pixelAspectRatio", "float", bytes_of<float>({1}));
  add_attribute(header, "screenWindowCenter", "v2f", bytes_of<float>({0, 0}));
  add_attribute(header, "screenWindowWidth", "float", bytes_of<float>({1}));
  for (const auto& [name, text] : stated.texts) add_attribute(header, name, "string", text);
  return header;
}

std::string header_of(int width, int height, const Channels& channels, const ExrHeader& stated) {
  return bytes_of<std::uint8_t>({0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0}) +
         attributes_of(width, height, channels, stated) + '\0';
}

}  // namespace

std::string layered_exr(int width, int height, const Channels& channels, const ExrHeader& stated) {
  std::string bytes = header_of(width, height, channels, stated);
  std::string rows;
  const std::size_t first = bytes.size() + std::size_t(height) * sizeof(std::uint64_t);
  for (int y = 0; y < height; ++y) {
    std::string row;
    for (const auto& [name, values] : channels) {
      const int step = sampling(values, width, height);
      for (int x = 0; x < width && y % step == 0; x += step)
        add(row, values[std::size_t(y / step * (width / step) + x / step)]);
    }
    add(bytes, std::uint64_t(first + rows.size()));
    add(rows, std::int32_t(stated.y + y));
    add(rows, std::int32_t(row.size()));
    rows += row;
  }
  return bytes + rows;
}

std::string exr_of_parts(const std::vector<std::pair<std::string, float>>& parts) {
  std::string bytes = bytes_of<std::uint8_t>({0x76, 0x2f, 0x31, 0x01, 2, 0x10, 0, 0});
  for (const auto& [name, value] : parts) {
    bytes += attributes_of(1, 1, {{"Y", {value}}}, {.texts = {{"name", name}, {"type", "scanlineimage"}}});
    add_attribute(bytes, "chunkCount", "int", bytes_of<std::int32_t>({1}));
    bytes += '\0';
  }
  bytes += '\0';
  // Number of the part, row, bytes, and the value.
  constexpr std::size_t chunk_bytes = 16;
  const std::size_t first = bytes.size() + parts.size() * sizeof(std::uint64_t);
  for (std::size_t i = 0; i < parts.size(); ++i) add(bytes, std::uint64_t(first + i * chunk_bytes));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    bytes += bytes_of<std::int32_t>({std::int32_t(i), 0, 4});
    add(bytes, parts[i].second);
  }
  return bytes;
}

}  // namespace twinray::test
