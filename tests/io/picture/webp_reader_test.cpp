// SPDX-License-Identifier: Apache-2.0
// WebP pictures, made by libwebp: their colours and alphas come out, and what is wrong with them is told.
#include "io/picture/webp_reader.h"

#include <webp/encode.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

constexpr int webp_width = 40, webp_height = 24;

/// Of four bytes a pixel, which change slowly. The alpha is nowhere 0: colours there are not kept.
std::vector<std::uint8_t> webp_pixels() {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < webp_height; ++y)
    for (int x = 0; x < webp_width; ++x)
      for (int c = 0; c < 4; ++c) bytes.push_back(std::uint8_t(40 + 2 * x + y * c + 20 * c));
  return bytes;
}

std::string taken(std::uint8_t* bytes, std::size_t size) {
  std::string file(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

std::string lossless(int width, int height, const std::vector<std::uint8_t>& pixels) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), width, height, 4 * width, &bytes);
  return taken(bytes, size);
}

std::string lossy(const std::vector<std::uint8_t>& pixels) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeRGBA(pixels.data(), webp_width, webp_height, 4 * webp_width, 98, &bytes);
  return taken(bytes, size);
}

const std::string webp_name = "a.webp";

std::string fault_of(const std::string& bytes) {
  try {
    decode_image(bytes, webp_name);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a WebP picture has the colours and the alpha that it was made of") {
  const std::vector<std::uint8_t> pixels = webp_pixels();
  for (const bool is_exact : {true, false}) {
    const std::string bytes = is_exact ? lossless(webp_width, webp_height, pixels) : lossy(pixels);
    const PictureSize size = webp_size({bytes, webp_name});
    REQUIRE((size.width == webp_width && size.height == webp_height));
    const Image colors = decode_webp({bytes, webp_name}), alpha = decode_webp_alpha({bytes, webp_name});
    const float tolerance = is_exact ? 1e-7f : 8.0f / 255;
    for (std::size_t i = 0; i < colors.pixels.size(); ++i) {
      const auto byte = [&](std::size_t channel) { return float(pixels[4 * i + channel]) / 255; };
      REQUIRE(std::fabs(colors.pixels[i].r - byte(0)) <= tolerance);
      REQUIRE(std::fabs(colors.pixels[i].g - byte(1)) <= tolerance);
      REQUIRE(std::fabs(colors.pixels[i].b - byte(2)) <= tolerance);
      REQUIRE(std::fabs(alpha.pixels[i].g - byte(3)) <= 1e-7f);  // Never lossy.
    }
  }
}

TEST_CASE("a WebP picture is sRGB, data where these are asked for, and a number by its alpha") {
  const std::string bytes = lossless(1, 1, {188, 0, 255, 51});
  const auto read = [&](PictureRole role, PictureChannels channels) {
    ReadOptions options;
    options.role = role, options.channels = channels;
    return decode_image(bytes, webp_name, options).pixels.at(0);
  };
  CHECK(read(PictureRole::color, PictureChannels::color).r == Approx(0.5029).epsilon(1e-3));
  CHECK(read(PictureRole::data, PictureChannels::color).r == Approx(188.0 / 255));
  CHECK(read(PictureRole::data, PictureChannels::blue).r == 1);
  CHECK(read(PictureRole::data, PictureChannels::alpha).r == Approx(51.0 / 255));
  CHECK(read(PictureRole::data, PictureChannels::number).r == Approx(51.0 / 255));
}

TEST_CASE("a WebP picture that is cut off, damaged or none is an error, and so is one that moves") {
  const std::string whole = lossless(webp_width, webp_height, webp_pixels());
  CHECK(fault_of(whole).empty());
  CHECK(fault_of(whole.substr(0, 10)) == "a.webp: cannot be read: its header is cut off");
  CHECK(fault_of(whole.substr(0, whole.size() / 2)) ==
        "a.webp: cannot be read: its data are cut off or damaged");
  CHECK(fault_of("\x89PNG" + whole) == "a.webp: cannot be read: it does not begin as a WebP picture does");
  CHECK(fault_of("").starts_with("a.webp: cannot be read: its header is cut off"));
  // The header of an extended file, whose second flag says that it moves.
  const std::string moves{"RIFF\x16\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\0\0\0\0\0\0", 30};
  CHECK(fault_of(moves) == "a.webp: cannot be read: it moves; valid is a still picture");
  // One that says that it is larger than its file can be.
  std::string large{"RIFF\x16\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\x3f\0\xff\x3f\0", 30};
  CHECK(fault_of(large).find("says that it has 16384 x 16384 pixels") != std::string::npos);
}

}  // namespace twinray::test
