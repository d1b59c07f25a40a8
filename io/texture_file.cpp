// SPDX-License-Identifier: Apache-2.0
#include "io/texture_file.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::int64_t most_pixels = 1 << 26;

/// What is shown in place of a file that cannot be used, and how a warning names it.
struct StandIn {
  Rgb color;
  const char* words;
};
constexpr StandIn magenta{{1, 0, 1}, "it is shown magenta"};
constexpr StandIn flat{{0.5f, 0.5f, 1}, "the surface stays flat"};

Image picture_of(const StandIn& stand_in) {
  Image image(1, 1);
  image.pixels[0] = stand_in.color;
  return image;
}

/// How many pixels were not finite, and now are black.
std::size_t blacken(Image& image) {
  std::size_t count = 0;
  for (Rgb& pixel : image.pixels) {
    if (is_finite(pixel)) continue;
    pixel = {};
    ++count;
  }
  return count;
}

struct ReadPicture {
  Image image;
  std::string warning;
};

ReadPicture read(const std::string& path, const ReadOptions& options, const StandIn& stand_in) {
  try {
    Image image = read_image(path, options);
    const std::size_t blackened = blacken(image);
    std::string warning;
    if (blackened > 0)
      warning = fmt::format("{}: {} of {} x {} pixels are not finite; they are black", path, blackened,
                            image.width, image.height);
    return {std::move(image), warning};
  } catch (const Error& error) {
    return {picture_of(stand_in), fmt::format("{}; {}", error.what(), stand_in.words)};
  }
}

LoadedTexture load(ReadPicture picture, TextureStore* store) {
  MipMap map(std::move(picture.image));
  return {store ? store->keep(std::move(map)) : std::make_shared<const MipMap>(std::move(map)),
          std::move(picture.warning)};
}

}  // namespace

LoadedTexture load_texture(const std::string& path, const PictureMeaning& meaning, TextureStore* store) {
  return load(read(path, {meaning.role, meaning.channels, most_pixels}, magenta), store);
}

LoadedTexture load_normal_map(const std::string& path, TextureStore* store) {
  return load(read(path, {PictureRole::data, PictureChannels::color, most_pixels}, flat), store);
}

}  // namespace twinray
