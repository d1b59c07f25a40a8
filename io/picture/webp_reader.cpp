// SPDX-License-Identifier: Apache-2.0
#include "io/picture/webp_reader.h"

#include <webp/decode.h>

#include <cstdint>
#include <vector>

namespace twinray {
namespace {

const std::uint8_t* data_of(const PictureBytes& picture) {
  return reinterpret_cast<const std::uint8_t*>(picture.bytes.data());
}

WebPBitstreamFeatures features_of(const PictureBytes& picture) {
  WebPBitstreamFeatures features;
  switch (WebPGetFeatures(data_of(picture), picture.bytes.size(), &features)) {
    case VP8_STATUS_OK:
      break;
    case VP8_STATUS_NOT_ENOUGH_DATA:
      fail_picture(picture, "its header is cut off");
    default:
      fail_picture(picture, "it does not begin as a WebP picture does");
  }
  if (features.has_animation) fail_picture(picture, "it moves; valid is a still picture");
  return features;
}

/// All pixels, each made of its four bytes.
template <typename Make>
Image read(const PictureBytes& picture, const Make& make) {
  const WebPBitstreamFeatures features = features_of(picture);
  Image image(features.width, features.height);
  std::vector<std::uint8_t> bytes(4 * image.pixels.size());
  if (!WebPDecodeRGBAInto(data_of(picture), picture.bytes.size(), bytes.data(), bytes.size(),
                          4 * features.width))
    fail_picture(picture, "its data are cut off or damaged");
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = make(&bytes[4 * i]);
  return image;
}

float unit(std::uint8_t byte) { return float(byte) * (1.0f / 255); }  // As of PNG and JPEG.

}  // namespace

PictureSize webp_size(const PictureBytes& picture) {
  const WebPBitstreamFeatures features = features_of(picture);
  return {features.width, features.height};
}

Image decode_webp(const PictureBytes& picture) {
  return read(picture, [](const std::uint8_t* p) { return Rgb{unit(p[0]), unit(p[1]), unit(p[2])}; });
}

Image decode_webp_alpha(const PictureBytes& picture) {
  return read(picture, [](const std::uint8_t* p) { return Rgb{unit(p[3]), unit(p[3]), unit(p[3])}; });
}

}  // namespace twinray
