// SPDX-License-Identifier: Apache-2.0
#include "io/picture/hdr_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// The pixels of an older file: four bytes each, a repetition of the one before them being 1 1 1 and a count,
/// times 256 for each repetition right before it (Ward, "Real Pixels", Graphics Gems II). OpenImageIO takes
/// these for pixels.
class OldRows {
 public:
  OldRows(std::string_view stored, int width, int height)
      : stored_(stored), row_bytes_(pixel_bytes * std::size_t(width)), height_(std::size_t(height)) {}

  /// Of the rows without repetitions; none where they have none, or are no such rows.
  std::optional<std::string> plain() {
    if (is_newer() || stored_.size() >= row_bytes_ * height_) return std::nullopt;
    for (std::size_t row = 0; row < height_; ++row)
      if (!add_row()) return std::nullopt;
    return std::move(made_);
  }

 private:
  static constexpr std::size_t pixel_bytes = 4;

  /// Whether each row begins with 2, 2 and its width, and has each channel for itself.
  bool is_newer() const {
    const std::size_t width = row_bytes_ / pixel_bytes;
    return width >= 8 && width < 32768 && stored_.starts_with("\2\2") && stored_.size() > 2 &&
           static_cast<unsigned char>(stored_[2]) < 128;
  }
  bool add_row() {
    const std::size_t begin = made_.size(), end = begin + row_bytes_;
    for (std::size_t unit = 1; made_.size() < end;) {
      if (stored_.size() < pixel_bytes) return false;
      const std::string_view pixel = stored_.substr(0, pixel_bytes);
      stored_.remove_prefix(pixel_bytes);
      if (pixel.starts_with("\1\1\1")) {
        const std::size_t count = unit * static_cast<unsigned char>(pixel[3]);
        if (made_.size() == begin || count > (end - made_.size()) / pixel_bytes) return false;
        const std::string last = made_.substr(made_.size() - pixel_bytes);
        for (std::size_t i = 0; i < count; ++i) made_ += last;
        unit *= 256;
        if (unit > most_unit) return false;
      } else {
        made_ += pixel;
        unit = 1;
      }
    }
    return true;
  }

  static constexpr std::size_t most_unit = std::size_t(1) << 32;

  std::string_view stored_;
  std::size_t row_bytes_, height_;
  std::string made_;
};

/// The whole file with such pixels.
std::optional<std::string> without_repetitions(const PictureBytes& picture, std::string_view pixels) {
  const PictureSize size = check_picture_header(PictureFormat::hdr, picture);
  auto plain = OldRows(pixels, int(size.width), int(size.height)).plain();
  if (plain) plain->insert(0, picture.bytes.substr(0, picture.bytes.size() - pixels.size()));
  return plain;
}

}  // namespace

Image decode_hdr(const PictureBytes& picture, const HeaderCheck& check) {
  const std::size_t end = picture.bytes.find("\n\n");  // There is one: the header is checked.
  std::string_view rest = picture.bytes.substr(end + 2);
  const std::string_view size = take_line(rest);
  const std::size_t x = size.find('X'), y = size.find('Y');
  if (x < y) fail_picture(picture, "its rows run from top to bottom; valid are sizes such as -Y 480 +X 640");
  const auto plain = without_repetitions(picture, rest);
  Image image = image_codec().read_hdr(plain ? PictureBytes{*plain, picture.path} : picture, check);
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
