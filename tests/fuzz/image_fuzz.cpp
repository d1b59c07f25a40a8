// SPDX-License-Identifier: Apache-2.0
// What is checked before and while a picture is read, on any bytes. The first byte chooses the name's ending,
// and so the format; the others are the file. A picture of many pixels ends with its checks: the readers'
// loops see no more in it than in a small one, and each would take the time of a thousand inputs.
#include <cstdint>
#include <string>

#include "core/error.h"
#include "io/picture/image_file.h"
#include "io/picture/picture_header.h"
#include "tests/fuzz/require.h"

namespace {

constexpr long long most_pixels = 1 << 12;

std::string ending(std::uint8_t letter) {
  switch (letter) {
    case 'e':
      return ".exr";
    case 'h':
      return ".hdr";
    case 'j':
      return ".jpg";
    case 't':
      return ".tga";
    case 'w':
      return ".webp";
    default:
      return ".png";
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string name = "input" + ending(data[0]);
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const auto [width, height] = twinray::check_picture_header(twinray::picture_format(name), {bytes, name});
    if (width * height > most_pixels) return 0;
    const twinray::Image image = twinray::decode_image(bytes, name);
    twinray::fuzz::require(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  } catch (const twinray::Error& error) {
    twinray::fuzz::require(std::string_view(error.what()).starts_with(name));
  }
  return 0;
}
