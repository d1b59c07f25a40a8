// SPDX-License-Identifier: Apache-2.0
// Zip archives of a few files, for tests: stored as they are, without compression.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace twinray::test {

struct ZipEntry {
  std::string name, text;
  std::uint32_t stated_size = 0;  ///< What the archive says of its size; 0: the truth.
};

inline std::uint32_t crc32(const std::string& text) {
  std::uint32_t crc = 0xffffffff;
  for (const unsigned char byte : text) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc;
}

/// Numbers of so many bytes, the lowest first.
inline std::string bytes_of(std::initializer_list<std::pair<int, std::uint32_t>> fields) {
  std::string bytes;
  for (const auto& [count, value] : fields)
    for (int i = 0; i < count; ++i) bytes += char((value >> (8 * i)) & 0xff);
  return bytes;
}

/// The bytes of a zip archive of these files.
inline std::string zip_text(const std::vector<ZipEntry>& entries) {
  std::string archive, directory;
  for (const ZipEntry& entry : entries) {
    const auto size = std::uint32_t(entry.text.size()), name = std::uint32_t(entry.name.size());
    const std::uint32_t stated = entry.stated_size > 0 ? entry.stated_size : size;
    const std::uint32_t method = stated == size ? 0 : 8, offset = std::uint32_t(archive.size());
    const std::string common = bytes_of({{2, 20},
                                         {2, 0},
                                         {2, method},
                                         {4, 0},
                                         {4, crc32(entry.text)},
                                         {4, size},
                                         {4, stated},
                                         {2, name},
                                         {2, 0}});
    archive += "PK\x03\x04" + common + entry.name + entry.text;
    directory += "PK\x01\x02" + bytes_of({{2, 20}}) + common +
                 bytes_of({{2, 0}, {2, 0}, {2, 0}, {4, 0}, {4, offset}}) + entry.name;
  }
  const auto count = std::uint32_t(entries.size());
  return archive + directory + "PK\x05\x06" +
         bytes_of({{2, 0},
                   {2, 0},
                   {2, count},
                   {2, count},
                   {4, std::uint32_t(directory.size())},
                   {4, std::uint32_t(archive.size())},
                   {2, 0}});
}

}  // namespace twinray::test
