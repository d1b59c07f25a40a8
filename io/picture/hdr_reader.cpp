// SPDX-License-Identifier: Apache-2.0
#include "io/picture/hdr_reader.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/decimal.h"
#include "io/picture/image_codec.h"

namespace twinray {
namespace {

std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

std::string_view without_blanks(std::string_view word) {
  word.remove_prefix(std::min(word.find_first_not_of(" \t"), word.size()));
  return word.substr(0, word.find_last_not_of(" \t\r") + 1);
}

/// What the pixels were multiplied by: the product of all that the header says.
float exposure_of(std::string_view header) {
  constexpr std::string_view name = "EXPOSURE=";
  double exposure = 1;
  while (!header.empty())
    if (const std::string_view line = take_line(header); line.starts_with(name))
      exposure *= read_decimal<double>(without_blanks(line.substr(name.size()))).value;
  return std::isnormal(float(exposure)) && exposure > 0 ? float(exposure) : 1;
}

}  // namespace

Image decode_hdr(const PictureBytes& picture, const HeaderCheck& check) {
  const std::size_t end = picture.bytes.find("\n\n");  // There is one: the header is checked.
  std::string_view rest = picture.bytes.substr(end + 2);
  const std::string_view size = take_line(rest);
  const std::size_t x = size.find('X'), y = size.find('Y');
  if (x < y) fail_picture(picture, "its rows run from top to bottom; valid are sizes such as -Y 480 +X 640");
  Image image = image_codec().read_hdr(picture, check);
  if (const float exposure = exposure_of(picture.bytes.substr(0, end)); exposure != 1)
    for (Rgb& pixel : image.pixels) pixel = pixel * (1 / exposure);
  const auto row = [&](int number) { return image.pixels.begin() + std::ptrdiff_t(number) * image.width; };
  if (size[x - 1] == '-')
    for (int number = 0; number < image.height; ++number) std::reverse(row(number), row(number + 1));
  if (size[y - 1] == '+')
    for (int upper = 0, lower = image.height - 1; upper < lower; ++upper, --lower)
      std::swap_ranges(row(upper), row(upper + 1), row(lower));
  return image;
}

}  // namespace twinray
