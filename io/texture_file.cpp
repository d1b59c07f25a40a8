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

LoadedTexture load(const std::string& path, const ReadOptions& options, const StandIn& stand_in) {
  try {
    Image image = read_image(path, options);
    const std::size_t blackened = blacken(image);
    std::string warning;
    if (blackened > 0)
      warning = fmt::format("{}: {} of {} x {} pixels are not finite; they are black", path, blackened,
                            image.width, image.height);
    return {std::make_shared<const MipMap>(std::move(image)), warning};
  } catch (const Error& error) {
    return {std::make_shared<const MipMap>(picture_of(stand_in)),
            fmt::format("{}; {}", error.what(), stand_in.words)};
  }
}

}  // namespace

LoadedTexture load_texture(const std::string& path, PictureRole role, PictureChannels channels) {
  return load(path, {role, channels, most_pixels}, magenta);
}

LoadedTexture load_normal_map(const std::string& path) {
  return load(path, {PictureRole::data, PictureChannels::color, most_pixels}, flat);
}

}  // namespace twinray
