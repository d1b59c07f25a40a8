// SPDX-License-Identifier: Apache-2.0
#include "io/picture/plain_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "io/decimal.h"

namespace twinray {
namespace {

constexpr float Rgb::*all_channels[] = {&Rgb::r, &Rgb::g, &Rgb::b};

struct PfmHeader {
  int channels = 3;
  PictureSize size;
  bool is_big_endian = false;
  float scale = 1;  ///< What the numbers are multiplied by, as pbrt does it.
  std::size_t length = 0;
};

/// Four words: PF or Pf, width, height, and a scale, negative where floats are little-endian; then one byte
/// of white space (P. Debevec's description of the format), or the two that end a line of Windows.
PfmHeader pfm_header(const PictureBytes& picture) {
  PfmHeader header;
  std::array<std::string_view, 4> words;
  const std::string_view bytes = picture.bytes;
  std::size_t at = 0;
  for (std::string_view& word : words) {
    at = std::min(bytes.find_first_not_of(" \n\r\t", at), bytes.size());
    const std::size_t end = std::min(bytes.find_first_of(" \n\r\t", at), bytes.size());
    word = bytes.substr(at, end - at);
    at = end;
  }
  if (words[0] != "PF" && words[0] != "Pf") fail_picture(picture, "it does not begin as a PFM picture does");
  const auto read = [&](std::string_view word, long long& side) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), side);
    if (error != std::errc() || end != word.data() + word.size())
      fail_picture(picture, "its header states no size");
  };
  read(words[1], header.size.width);
  read(words[2], header.size.height);
  header.channels = words[0] == "PF" ? 3 : 1;
  const auto scale = read_decimal<float>(words[3]);
  if (scale.fault != DecimalFault::none || scale.value == 0)
    fail_picture(picture, "its header ends in no scale such as -1.0");
  header.is_big_endian = scale.value > 0;
  header.scale = std::fabs(scale.value);
  header.length = std::min(at + (bytes.substr(at, 2) == "\r\n" ? 2 : 1), bytes.size());
  return header;
}

float float_at(const char* bytes, bool is_big_endian) {
  std::array<char, 4> raw;
  std::memcpy(raw.data(), bytes, 4);
  if (is_big_endian) std::reverse(raw.begin(), raw.end());
  float value;
  std::memcpy(&value, raw.data(), 4);
  return value;
}

constexpr std::size_t tga_header_bytes = 18;

int byte_of(const PictureBytes& picture, std::size_t at) {
  if (at >= picture.bytes.size()) fail_picture(picture, "it is cut off");
  return static_cast<unsigned char>(picture.bytes[at]);
}

/// The pixels of a TGA file one after the other, out of their runs.
class TgaPixels {
 public:
  TgaPixels(const PictureBytes& picture, bool is_packed, std::size_t channels, bool reads_alpha)
      : picture_(picture),
        is_packed_(is_packed),
        reads_alpha_(reads_alpha),
        channels_(channels),
        at_(tga_header_bytes + std::size_t(byte_of(picture, 0))) {}

  Rgb next() {
    if (is_packed_ && left_ == 0) {
      const int head = byte_of(picture_, at_++);
      left_ = (head & 127) + 1;
      is_run_ = head >= 128;
      if (is_run_) color_ = read();
    }
    --left_;
    return is_packed_ && is_run_ ? color_ : read();
  }

 private:
  /// Blue, green, red and alpha, or grey alone.
  Rgb read() {
    const auto channel = [&](std::size_t i) { return float(byte_of(picture_, at_ + i)) / 255; };
    const auto grey = [](float value) { return Rgb{value, value, value}; };
    const Rgb color = reads_alpha_    ? grey(channels_ > 3 ? channel(3) : 1)
                      : channels_ < 3 ? grey(channel(0))
                                      : Rgb{channel(2), channel(1), channel(0)};
    at_ += channels_;
    return color;
  }

  const PictureBytes& picture_;
  bool is_packed_, reads_alpha_;
  std::size_t channels_, at_;
  int left_ = 0;
  bool is_run_ = false;
  Rgb color_;
};

Image decode_tga(const PictureBytes& picture, bool reads_alpha) {
  const PictureSize size = tga_size(picture);
  const int kind = byte_of(picture, 2), depth = byte_of(picture, 16), order = byte_of(picture, 17);
  const bool is_grey = (kind & 7) == 3, is_packed = kind >= 8;
  const bool is_known = (kind == 2 || kind == 3 || kind == 10 || kind == 11) && byte_of(picture, 1) == 0;
  if (!is_known || (is_grey ? depth != 8 : depth != 24 && depth != 32))
    fail_picture(picture, "TGA pictures are read of 24 or 32 bits a pixel, or 8 of grey, without a palette");
  TgaPixels pixels(picture, is_packed, std::size_t(depth / 8), reads_alpha);
  Image image(int(size.width), int(size.height));
  const bool from_top = (order & 32) != 0, from_right = (order & 16) != 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image.at(from_right ? image.width - 1 - column : column, from_top ? row : image.height - 1 - row) =
          pixels.next();
  return image;
}

}  // namespace

PictureSize pfm_size(const PictureBytes& picture) { return pfm_header(picture).size; }

PictureSize tga_size(const PictureBytes& picture) {
  if (picture.bytes.size() < tga_header_bytes) fail_picture(picture, "its header is cut off");
  const auto side = [&](std::size_t at) { return byte_of(picture, at) + 256 * byte_of(picture, at + 1); };
  return {side(12), side(14)};
}

/// Rows run from the bottom.
Image decode_pfm(const PictureBytes& picture) {
  const PfmHeader header = pfm_header(picture);
  const std::size_t row = std::size_t(header.size.width) * std::size_t(header.channels) * 4;
  if ((picture.bytes.size() - header.length) / row < std::size_t(header.size.height))
    fail_picture(picture, "it is cut off");
  Image image(int(header.size.width), int(header.size.height));
  const char* at = picture.bytes.data() + header.length;
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x, at += 4 * header.channels) {
      const auto channel = [&](int c) { return header.scale * float_at(at + 4 * c, header.is_big_endian); };
      image.at(x, y) = header.channels == 3 ? Rgb{channel(0), channel(1), channel(2)}
                                            : Rgb{channel(0), channel(0), channel(0)};
    }
  return image;
}

/// Of the kinds of the format (Truevision, 1991) true color and grey, 2 and 3, and the same in runs, 10 and
/// 11.
Image decode_tga(const PictureBytes& picture) { return decode_tga(picture, false); }
/// Programs that know no alpha leave its byte 0 everywhere, and say that none of its bits mean anything.
Image decode_tga_alpha(const PictureBytes& picture) {
  Image alpha = decode_tga(picture, true);
  const bool has_bits = (byte_of(picture, 17) & 15) != 0;
  const auto is_zero = [](const Rgb& pixel) { return pixel == Rgb{}; };
  if (!has_bits && std::all_of(alpha.pixels.begin(), alpha.pixels.end(), is_zero))
    std::fill(alpha.pixels.begin(), alpha.pixels.end(), white);
  return alpha;
}

std::string encode_pfm(const Image& image, int channels) {
  std::string bytes = fmt::format("{}\n{} {}\n-1\n", channels == 1 ? "Pf" : "PF", image.width, image.height);
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x)
      for (float Rgb::*const channel : std::span(all_channels).first(std::size_t(channels))) {
        const auto bits = std::bit_cast<std::uint32_t>(image.at(x, y).*channel);
        for (int shift = 0; shift < 32; shift += 8) bytes.push_back(char(bits >> shift & 0xff));
      }
  return bytes;
}

}  // namespace twinray
