// SPDX-License-Identifier: Apache-2.0
#include "io/cs184/picture.h"

#include <algorithm>

#include "core/elementary.h"

namespace twinray {
namespace {

/// The program holds both as floats, and raises to the power in double.
constexpr float exposure = 1.41421356f, exponent = 1 / 2.2f;

constexpr std::size_t ending_length = 4;  // of ".png"

}  // namespace

std::uint8_t encode_cs184(float linear) {
  if (!(linear > 0)) return 0;
  const double exposed = std::min(double(linear) * exposure, 1.0);
  return std::uint8_t(255 * float(pow_of(exposed, exponent)));
}

ByteImage encode_cs184(const Image& image) {
  ByteImage bytes{image.width, image.height, {}};
  bytes.bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (const float channel : {pixel.r, pixel.g, pixel.b}) bytes.bytes.push_back(encode_cs184(channel));
  return bytes;
}

ByteImage cs184_rate_image(const Film& film, std::uint32_t most) {
  const PixelRect& window = film.window();
  const ByteImage part = sample_rate_image(film, most);
  ByteImage whole{film.frame_width(), film.frame_height(), {}};
  const std::array<std::uint8_t, 3> none = rate_color(0);
  const std::size_t pixels = std::size_t(whole.width) * std::size_t(whole.height);
  whole.bytes.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) whole.bytes.insert(whole.bytes.end(), none.begin(), none.end());
  for (int y = 0; y < part.height; ++y) {
    const auto row = part.bytes.begin() + std::ptrdiff_t(3) * y * part.width;
    const std::ptrdiff_t to = (std::ptrdiff_t(window.y0) + y) * whole.width + window.x0;
    std::copy_n(row, 3 * part.width, whole.bytes.begin() + 3 * to);
  }
  return whole;
}

std::string cs184_rate_name(const std::string& picture) {
  const std::size_t slash = picture.find_last_of('/');
  const std::size_t name_begin = slash == std::string::npos ? 0 : slash + 1;
  const bool has_ending = picture.size() >= name_begin + ending_length;
  return picture.substr(0, has_ending ? picture.size() - ending_length : picture.size()) + "_rate.png";
}

PixelRect cs184_cell(int x, int y, int width, int height, int frame_height) {
  return {x, frame_height - y - height, x + width, frame_height - y};
}

}  // namespace twinray
