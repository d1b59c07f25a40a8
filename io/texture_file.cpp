// SPDX-License-Identifier: Apache-2.0
#include "io/texture_file.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"

namespace twinray {
namespace {

constexpr std::int64_t most_pixels = 1 << 26;

Image magenta() {
  Image image(1, 1);
  image.pixels[0] = {1, 0, 1};
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

}  // namespace

LoadedTexture load_texture(const std::string& path, PictureRole role, PictureChannels channels) {
  try {
    Image image = read_image(path, {role, channels, most_pixels});
    const std::size_t blackened = blacken(image);
    std::string warning;
    if (blackened > 0)
      warning = fmt::format("{}: {} of {} x {} pixels are not finite; they are black", path, blackened,
                            image.width, image.height);
    return {std::make_shared<const MipMap>(std::move(image)), warning};
  } catch (const Error& error) {
    return {std::make_shared<const MipMap>(magenta()), fmt::format("{}; it is shown magenta", error.what())};
  }
}

}  // namespace twinray
