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

/// The next word of a line, as a number; 0 where it is none.
double take_number(std::string_view& line) {
  line = without_blanks(line);
  const std::string_view word = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(word.size());
  return read_decimal<double>(word).value;
}

float factor_of(double product) { return std::isnormal(float(product)) && product > 0 ? float(product) : 1; }

/// What the pixels were multiplied by: the product of all that the header says, of all colours alike and of
/// each.
Rgb exposure_of(std::string_view header) {
  constexpr std::string_view of_all = "EXPOSURE=", of_each = "COLORCORR=";
  double product[3] = {1, 1, 1};
  while (!header.empty()) {
    std::string_view line = take_line(header);
    const bool is_of_all = line.starts_with(of_all);
    if (!is_of_all && !line.starts_with(of_each)) continue;
    line.remove_prefix(is_of_all ? of_all.size() : of_each.size());
    const std::string_view numbers = line;
    for (double& channel : product) {
      if (is_of_all) line = numbers;
      channel *= take_number(line);
    }
  }
  return {factor_of(product[0]), factor_of(product[1]), factor_of(product[2])};
}

}  // namespace

Image decode_hdr(const PictureBytes& picture, const HeaderCheck& check) {
  const std::size_t end = picture.bytes.find("\n\n");  // There is one: the header is checked.
  std::string_view rest = picture.bytes.substr(end + 2);
  const std::string_view size = take_line(rest);
  const std::size_t x = size.find('X'), y = size.find('Y');
  if (x < y) fail_picture(picture, "its rows run from top to bottom; valid are sizes such as -Y 480 +X 640");
  Image image = image_codec().read_hdr(picture, check);
  if (const Rgb exposure = exposure_of(picture.bytes.substr(0, end)); exposure != white)
    for (Rgb& pixel : image.pixels) pixel = pixel * Rgb{1 / exposure.r, 1 / exposure.g, 1 / exposure.b};
  const auto row = [&](int number) { return image.pixels.begin() + std::ptrdiff_t(number) * image.width; };
  if (size[x - 1] == '-')
    for (int number = 0; number < image.height; ++number) std::reverse(row(number), row(number + 1));
  if (size[y - 1] == '+')
    for (int upper = 0, lower = image.height - 1; upper < lower; ++upper, --lower)
      std::swap_ranges(row(upper), row(upper + 1), row(lower));
  return image;
}

}  // namespace twinray
