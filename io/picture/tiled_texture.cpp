// SPDX-License-Identifier: Apache-2.0
#include "io/picture/tiled_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/memory.h"
#include "io/input_file.h"
#include "io/output_file.h"
#include "io/picture/exr_tiled_file.h"
#include "io/picture/exr_writer.h"
#include "io/picture/picture_header.h"

namespace twinray {
namespace {

/// Says that the levels are ours; another filter would be another version.
constexpr const char* levels_name = "twinray:levels";
constexpr const char* levels_value = "box, version 1";
constexpr const char* role_name = "twinray:role";
constexpr const char* channels_name = "twinray:channels";
constexpr const char* range_name = "twinray:range";

const char* range_word(bool is_within_unit) { return is_within_unit ? "within [0, 1]" : "beyond [0, 1]"; }

const char* word(PictureRole role) { return role == PictureRole::data ? "data" : "color"; }

class ExrTiles final : public TileSource {
 public:
  ExrTiles(const TileLayout& layout, std::unique_ptr<const TiledExr> file)
      : layout_(layout), file_(std::move(file)) {}

  void read(std::uint32_t tile, std::span<Rgb> texels) const override {
    if (tile == layout_.tiles() - 1) return read_small(texels);
    int index = 0;
    while (index + 1 < layout_.levels() && layout_.level(index + 1).first_tile <= tile) ++index;
    const TileLayout::Level& level = layout_.level(index);
    const std::uint32_t place = tile - level.first_tile;
    read_finite({index, int(place % level.columns), int(place / level.columns)}, texels);
  }

 private:
  /// The levels that share a tile have one each in the file.
  void read_small(std::span<Rgb> texels) const {
    std::vector<Rgb> tile(texels_a_tile);
    for (int index = 0; index < layout_.levels(); ++index) {
      const TileLayout::Level& level = layout_.level(index);
      if (level.first_tile != layout_.tiles() - 1) continue;
      read_finite({index, 0, 0}, tile);
      for (int y = 0; y < level.height; ++y)
        std::copy_n(&tile[std::size_t(y) * tile_side], level.width,
                    &texels[level.offset + std::size_t(y) * level.stride]);
    }
  }

  /// What is not finite was not written by us: it is 0, as in every texture.
  void read_finite(const TiledExr::Tile& tile, std::span<Rgb> texels) const {
    file_->read(tile, texels);
    for (Rgb& texel : texels)
      if (!is_finite(texel)) texel = {};
  }

  TileLayout layout_;
  std::unique_ptr<const TiledExr> file_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw Error(fmt::format("{}: {}; --convert-textures writes it anew", path, reason));
}

std::string text(const TiledExr& file, const char* name) {
  for (const auto& [key, value] : file.metadata())
    if (key == name) return value;
  return "";
}

PictureMeaning meaning_of(const TiledExr& file, const std::string& path) {
  if (text(file, levels_name) != levels_value) refuse(path, "its levels are not those of this program");
  const std::string role = text(file, role_name), channels = text(file, channels_name);
  for (const PictureRole r : {PictureRole::color, PictureRole::data})
    for (int c = 0; c <= int(last_channels); ++c)
      if (role == word(r) && channels == channels_word(PictureChannels(c))) return {r, PictureChannels(c)};
  refuse(path, "it does not say what its numbers mean");
}

bool is_within_unit(const TiledExr& file, const std::string& path) {
  const std::string range = text(file, range_name);
  for (const bool is_within : {false, true})
    if (range == range_word(is_within)) return is_within;
  refuse(path, "it does not say whether its texels lie in [0, 1]");
}

void check_header(const TiledExr& file, const std::string& path) {
  const auto [width, height, levels, tile_width, tile_height] = file.size();
  if (tile_width != tile_side || tile_height != tile_side)
    refuse(path, fmt::format("its tiles have {} x {} texels; valid are {} x {}", tile_width, tile_height,
                             tile_side, tile_side));
  if (std::int64_t(width) * height > most_texture_pixels)
    throw Error(
        fmt::format("{}: {} x {} pixels; valid are up to {} here", path, width, height, most_texture_pixels));
  const TileLayout layout(width, height);
  if (levels != layout.levels())
    refuse(path,
           fmt::format("{} levels; a picture of {} x {} has {}", levels, width, height, layout.levels()));
  // Each tile has its place (8 bytes) and its head (20) in the file.
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error || bytes / 28 < layout.tiles() - 1)
    refuse(path, fmt::format("{} x {} pixels do not fit into {} bytes: it is cut off", width, height, bytes));
}

/// As much of a file as its header may have.
std::string beginning_of(const std::string& path) {
  check_regular_file(path, "picture");
  std::string bytes(std::size_t(1) << 20, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  file.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(file.gcount()));
  return bytes;
}

/// The level of one texel was written last: where it is there, the file is whole.
void check_end(const TiledExr& file, const TileLayout& layout) {
  std::vector<Rgb> last(texels_a_tile);
  file.read({layout.levels() - 1, 0, 0}, last);
}

}  // namespace

std::string tiled_name(const std::string& picture, const PictureMeaning& meaning) {
  const bool is_color = meaning.channels == PictureChannels::color;
  return fmt::format("{}{}{}{}.tx", picture, meaning.role == PictureRole::data ? ".data" : "",
                     is_color ? "" : ".", is_color ? "" : channels_word(meaning.channels));
}

bool is_tiled_name(const std::string& path) { return picture_ending(path) == ".tx"; }

TiledTexture open_tiled(const std::string& path) {
  const std::string beginning = beginning_of(path);
  check_exr_header({beginning, path});
  auto file = std::make_unique<const TiledExr>(path);
  check_header(*file, path);
  const PictureMeaning meaning = meaning_of(*file, path);
  const TileLayout layout(file->size().width, file->size().height);
  check_end(*file, layout);
  const bool is_within = is_within_unit(*file, path);
  return {layout, meaning, is_within, std::make_unique<const ExrTiles>(layout, std::move(file))};
}

MipMap read_whole(const TiledTexture& texture) {
  const TileLayout& layout = texture.layout;
  const MemoryNeed need{"the texels of a texture", layout.tiles() * texels_a_tile * sizeof(Rgb)};
  check_memory({&need, 1});
  std::vector<Image> levels;
  for (int i = 0; i < layout.levels(); ++i)
    levels.emplace_back(layout.level(i).width, layout.level(i).height);
  std::vector<Rgb> tile(texels_a_tile);
  for (int i = 0; i < layout.levels(); ++i)
    for (int top = 0; top < levels[std::size_t(i)].height; top += tile_side)
      for (int left = 0; left < levels[std::size_t(i)].width; left += tile_side) {
        Image& image = levels[std::size_t(i)];
        texture.tiles->read(layout.place(i, left, top).tile, tile);
        for (int y = top; y < std::min(top + tile_side, image.height); ++y)
          for (int x = left; x < std::min(left + tile_side, image.width); ++x)
            image.at(x, y) = tile[layout.place(i, x, y).texel];
      }
  return MipMap(std::move(levels));
}

void write_tiled(const std::string& path, const MipMap& map, const PictureMeaning& meaning) {
  const std::vector<unsigned char> bytes =
      encode_tiled_exr(map, tile_side,
                       {{levels_name, levels_value},
                        {role_name, word(meaning.role)},
                        {channels_name, channels_word(meaning.channels)},
                        {range_name, range_word(map.is_within_unit())},
                        {"twinray:color_space", meaning.role == PictureRole::data ? "none" : "linear sRGB"}});
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace twinray
