// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"

#include <algorithm>

#include "core/elementary.h"

namespace twinray {

Image mean_image(const Film& film) {
  const PixelRect& window = film.window();
  Image image(window.width(), window.height());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.at(x, y) = film.pixel(window.x0 + x, window.y0 + y).mean();
  return image;
}

std::array<std::uint8_t, 3> rate_color(float rate) {
  const auto byte = [](float c) { return std::uint8_t(255 * c); };
  if (rate <= 0.5f) {
    const float k = (0.5f - rate) / 0.5f;
    return {0, byte(1 - k), byte(k)};
  }
  const float k = (1 - rate) / 0.5f;
  return {byte(1 - k), byte(k), 0};
}

ByteImage sample_rate_image(const Film& film, std::uint32_t most) {
  const PixelRect& window = film.window();
  ByteImage image{window.width(), window.height(), {}};
  image.bytes.reserve(3 * std::size_t(image.width) * std::size_t(image.height));
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (const std::uint8_t byte : rate_color(std::min(1.0f, float(film.pixel(x, y).count) / float(most))))
        image.bytes.push_back(byte);
  return image;
}

Rgb mean_of(const Image& image) {
  double r = 0, g = 0, b = 0;
  for (const Rgb& pixel : image.pixels) r += pixel.r, g += pixel.g, b += pixel.b;
  const auto count = double(image.pixels.size());
  return {float(r / count), float(g / count), float(b / count)};
}

std::uint8_t encode_srgb(float linear) {
  if (!(linear > 0)) return 0;
  const double x = std::min(1.0, double(linear));
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * pow_of(x, 1 / 2.4) - 0.055;
  return std::uint8_t(255 * encoded + 0.5);
}

ByteImage encode_srgb(const Image& image) {
  ByteImage bytes{image.width, image.height, {}};
  bytes.bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (const float channel : {pixel.r, pixel.g, pixel.b}) bytes.bytes.push_back(encode_srgb(channel));
  return bytes;
}

}  // namespace twinray
