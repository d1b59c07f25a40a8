// SPDX-License-Identifier: Apache-2.0
#include "io/nanovdb/file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "io/byte_cursor.h"
#include "io/gzip.h"
#include "io/input_file.h"
#include "io/nanovdb/blosc.h"

namespace twinray {
namespace {

constexpr std::uint64_t file_magic =
    0x304244566f6e614e;  // "NanoVDB0"; files of later libraries end with 1 and 2.
constexpr std::uint64_t grid_magic = 0x314244566f6e614e, newer_file_magic = 0x324244566f6e614e;
constexpr std::uint32_t known_version = 32;

/// The header of a segment, and of each of its grids: in the file's order, little-endian.
struct SegmentHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint16_t grids, codec;
};
static_assert(sizeof(SegmentHeader) == 16);
struct GridHeader {
  std::uint64_t grid_size, file_size, name_key, voxels;
  std::uint32_t type, kind;
  double world_box[6];
  std::int32_t index_box[6];
  double voxel_size[3];
  std::uint32_t name_size, nodes[4], tiles[3];
  std::uint16_t codec, padding;
  std::uint32_t version;
};
static_assert(sizeof(GridHeader) == 176);

ByteCursor cursor(std::string_view bytes, const std::string& name) {
  return {bytes, name + ": the NanoVDB file"};
}

}  // namespace

NvdbFile::NvdbFile(std::string_view bytes, const std::string& name) : name_(name) {
  ByteCursor file = cursor(bytes, name);
  do {
    const auto segment = file.take<SegmentHeader>("its header");
    if (segment.magic != file_magic && segment.magic != grid_magic && segment.magic != newer_file_magic)
      throw Error(name + ": is not a NanoVDB file");
    if (const std::uint32_t version = segment.version >> 21; version != known_version)
      throw Error(fmt::format("{}: is a NanoVDB file of version {}; only version {} is read", name, version,
                              known_version));
    if (segment.codec > std::uint16_t(Codec::blosc))
      throw Error(
          fmt::format("{}: is packed by a codec of number {}; known are 0 (none), 1 (ZIP) and 2 (Blosc)",
                      name, segment.codec));
    const std::size_t first = entries_.size();
    std::vector<std::uint64_t> packed_sizes;
    for (int i = 0; i < int(segment.grids); ++i) {
      const auto header = file.take<GridHeader>("the header of a grid");
      std::string_view grid_name = file.take(header.name_size, "the name of a grid");
      grid_name = grid_name.substr(0, grid_name.find('\0'));
      entries_.push_back({grid_name, {}, header.grid_size, Codec(segment.codec)});
      packed_sizes.push_back(header.file_size);
    }
    for (std::size_t i = 0; i < packed_sizes.size(); ++i)
      entries_[first + i].packed = file.take(packed_sizes[i], "a grid");
  } while (!file.is_at_end());
}

std::vector<std::string_view> NvdbFile::grid_names() const {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries_) names.push_back(entry.name);
  return names;
}

const NvdbFile::Entry* NvdbFile::find(std::string_view grid) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.name == grid; });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::uint64_t> NvdbFile::grid(std::string_view grid) const {
  const Entry* const entry = find(grid);
  if (!entry)
    throw Error(
        fmt::format("{}: has no grid \"{}\"; it has \"{}\"", name_, grid, fmt::join(grid_names(), "\", \"")));
  if (entry->size > max_input_bytes)
    throw Error(fmt::format("{}: unpacked, the grid \"{}\" has {} bytes; the most that are read are {}",
                            name_, grid, entry->size, max_input_bytes));
  std::vector<std::uint64_t> unpacked((entry->size + 7) / 8);
  const std::span<char> room(reinterpret_cast<char*>(unpacked.data()), entry->size);
  ByteCursor packed = cursor(entry->packed, name_);
  if (entry->codec == Codec::none) {
    std::ranges::copy(packed.take(room.size(), "a grid"), room.begin());
  } else if (entry->codec == Codec::zip) {
    const auto size = packed.take<std::uint64_t>("a grid");
    unpack_zlib(packed.take(size, "a grid"), room, name_);
  } else {
    constexpr std::uint64_t block = std::uint64_t(1) << 30;
    for (std::uint64_t at = 0; at < room.size(); at += block) {
      const auto size = packed.take<std::uint64_t>("a grid");
      unpack_blosc(packed.take(size, "a grid"), room.subspan(at, std::min(block, room.size() - at)), name_);
    }
  }
  return unpacked;
}

}  // namespace twinray
