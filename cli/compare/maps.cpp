// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/maps.h"

#include <algorithm>
#include <cmath>

#include "io/display/color_scale.h"

namespace twinray::compare {
namespace {

double luminance_difference(const Image& picture, const Image& reference, std::size_t i) {
  return double(luminance(picture.pixels[i])) - double(luminance(reference.pixels[i]));
}

/// `color(i)` gives the bytes of pixel i.
template <class Color>
ByteImage byte_image(int width, int height, const Color& color) {
  ByteImage image{width, height, {}};
  const std::size_t count = std::size_t(width) * std::size_t(height);
  image.bytes.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bytes = color(i);
    image.bytes.insert(image.bytes.end(), bytes.begin(), bytes.end());
  }
  return image;
}

std::array<std::uint8_t, 3> scale_bytes(float share) {
  const Rgb c = scale_color(share);
  return {encode_srgb(c.r), encode_srgb(c.g), encode_srgb(c.b)};
}

}  // namespace

ByteImage flip_picture(const FlipMap& map) {
  return byte_image(map.width, map.height, [&](std::size_t i) { return scale_bytes(map.values[i]); });
}

ByteImage flip_scale() {
  return byte_image(256, 1, [](std::size_t i) { return scale_bytes(float(i) / 255); });
}

double full_difference(const Image& picture, const Image& reference) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    differences.push_back(std::abs(luminance_difference(picture, reference, i)));
  const auto most = differences.begin() + std::ptrdiff_t(differences.size() * 99 / 100);
  std::nth_element(differences.begin(), most, differences.end());
  return *most > 0 ? *most : *std::max_element(differences.begin(), differences.end());
}

ByteImage signed_picture(const Image& picture, const Image& reference, double full) {
  return byte_image(reference.width, reference.height, [&](std::size_t i) {
    return signed_color(full > 0 ? luminance_difference(picture, reference, i) / full : 0);
  });
}

}  // namespace twinray::compare
