// SPDX-License-Identifier: Apache-2.0
#include "io/picture/exr_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <algorithm>

#include "io/picture/exr_attributes.h"
#include "io/picture/exr_streams.h"

namespace twinray {
namespace {

/// A row of all channels, and as halves for those that are stored so.
struct Row {
  std::vector<float> numbers;
  std::vector<half> halves;
};

bool has_halves(const LayeredImage& image) {
  return std::any_of(image.channels.begin(), image.channels.end(),
                     [](const auto& channel) { return channel.is_half; });
}

/// Where the numbers of each pixel of any row lie.
Imf::FrameBuffer buffer_of(const LayeredImage& image, const ImageFrame& frame, Row& row) {
  const std::size_t count = image.channels.size();
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [name, is_half] = image.channels[i];
    const std::size_t bytes = is_half ? sizeof(half) : sizeof(float);
    char* const first =
        is_half ? reinterpret_cast<char*>(&row.halves[i]) : reinterpret_cast<char*>(&row.numbers[i]);
    buffer.insert(
        name, Imf::Slice(is_half ? Imf::HALF : Imf::FLOAT,
                         first - std::ptrdiff_t(frame.x) * std::ptrdiff_t(count * bytes), count * bytes, 0));
  }
  return buffer;
}

}  // namespace

std::vector<unsigned char> encode_exr(const LayeredImage& image, const ImageMetadata& metadata,
                                      const ImageFrame& frame) {
  Imf::Header header = header_of(image.width, image.height, metadata, frame);
  header.compression() =
      image.compression == ExrCompression::dwab ? Imf::DWAB_COMPRESSION : Imf::ZIP_COMPRESSION;
  for (const auto& [name, is_half] : image.channels)
    header.channels().insert(name, Imf::Channel(is_half ? Imf::HALF : Imf::FLOAT));
  std::vector<unsigned char> bytes;
  {
    MemoryOutput memory(bytes);
    Imf::OutputFile file(memory, header, no_threads);
    const std::size_t numbers = std::size_t(image.width) * image.channels.size();
    Row row{std::vector<float>(numbers), std::vector<half>(has_halves(image) ? numbers : 0)};
    file.setFrameBuffer(buffer_of(image, frame, row));
    for (int y = 0; y < image.height; ++y) {
      image.fill_row(y, row.numbers);
      std::copy_n(row.numbers.begin(), row.halves.size(), row.halves.begin());
      file.writePixels(1);
    }
  }  // The file's end writes where its rows are.
  return bytes;
}

std::vector<unsigned char> encode_tiled_exr(const MipMap& map, int side, const ImageMetadata& metadata) {
  const MipLevel size = map.level(0);
  Imf::Header header = header_of(size.width, size.height, metadata, {});
  header.setTileDescription({unsigned(side), unsigned(side), Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
  for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  std::vector<unsigned char> bytes;
  {
    MemoryOutput memory(bytes);
    Imf::TiledOutputFile file(memory, header, no_threads);
    for (int level = 0; level < map.levels(); ++level) {
      const Image& image = map.image(level);
      const Rgb& first = image.pixels[0];
      Imf::FrameBuffer buffer;
      for (const auto& [name, number] : {std::pair("R", &first.r), {"G", &first.g}, {"B", &first.b}})
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, number, file.dataWindowForLevel(level), sizeof(Rgb),
                                             sizeof(Rgb) * std::size_t(image.width)));
      file.setFrameBuffer(buffer);
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
  }
  return bytes;
}

}  // namespace twinray
