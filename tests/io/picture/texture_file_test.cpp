// SPDX-License-Identifier: Apache-2.0
#include "io/picture/texture_file.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>

#include "io/picture/known_pictures.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr Rgb magenta{1, 0, 1};

/// A PNG of two red pixels, with the alphas 1 and 0; written by Python's zlib and struct.
std::string rgba_png() {
  constexpr std::string_view digits =
      "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a0000000f49444154789c63f8cfc0f0"
      "1f88190010f802feace946f80000000049454e44ae426082";
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += char(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16));
  return bytes;
}

}  // namespace

TEST_CASE("a texture's colours are decoded from sRGB, its data are kept as they stand") {
  const TemporaryFolder folder;
  ByteImage bytes{2, 1, {0, 51, 255, 128, 128, 128}};
  write_png(folder.file("a.png"), bytes);
  const LoadedTexture color = load_texture(folder.file("a.png"), {PictureRole::color});
  const LoadedTexture data = load_texture(folder.file("a.png"), {PictureRole::data});
  CHECK(color.warning.empty());
  CHECK(data.warning.empty());
  CHECK(color.image->level(0).at(0, 0).g == Approx(0.0331047666));
  CHECK(color.image->level(0).at(1, 0).r == Approx(0.215860501));
  CHECK(data.image->level(0).at(0, 0).g == Approx(0.2));
  CHECK(data.image->level(0).at(1, 0).r == Approx(128 / 255.0));
  CHECK(color.image->levels() == 2);
  // The mean of colours is that of light, not of bytes.
  CHECK(color.image->level(1).at(0, 0).b == Approx((1 + 0.215860501) / 2));
}

TEST_CASE("known pictures are read once for each use of them") {
  const TemporaryFolder folder;
  write_png(folder.file("a.png"), ByteImage{1, 1, {128, 128, 128}});
  const LoadOptions options{.known = std::make_shared<KnownPictures>()};
  const auto read = [&](PictureRole role) {
    return load_texture(folder.file("a.png"), {role}, options).image;
  };
  const auto color = read(PictureRole::color), data = read(PictureRole::data);
  CHECK(read(PictureRole::color) == color);
  CHECK(read(PictureRole::data) == data);
  CHECK(color != data);
  CHECK(load_texture(folder.file("a.png"), {PictureRole::color}).image != color);
  const std::string missing = folder.file("b.png");
  const Rgb seen = load_texture(missing, {PictureRole::data}, options).image->level(0).at(0, 0);
  const Rgb normal = load_normal_map(missing, options).image->level(0).at(0, 0);
  CHECK(seen == magenta);
  CHECK(normal == Rgb{0.5f, 0.5f, 1});
  const std::string png = rgba_png();
  const auto decoded = decode_texture(png, "image 1", {}, options).image;
  CHECK(decode_texture(png, "image 1", {}, options).image == decoded);
  CHECK(decode_texture(png, "image 2", {}, options).image != decoded);
}

TEST_CASE("an EXR texture is linear in both roles, and what is not finite is black and named") {
  const TemporaryFolder folder;
  Image image(2, 1);
  image.pixels = {{0.5f, 2, 0.25f}, {std::numeric_limits<float>::quiet_NaN(), 1, 1}};
  write_exr(folder.file("a.exr"), image);
  for (const PictureRole role : {PictureRole::color, PictureRole::data}) {
    const LoadedTexture texture = load_texture(folder.file("a.exr"), {role});
    CHECK(texture.image->level(0).at(0, 0) == Rgb{0.5f, 2, 0.25f});
    CHECK(texture.image->level(0).at(1, 0) == Rgb{});
    CHECK(texture.warning ==
          fmt::format("{}: 1 of 2 x 1 pixels are not finite; they are black", folder.file("a.exr")));
  }
}

TEST_CASE("a picture's number is its alpha where that is not 1 all over, else the mean of its colour") {
  const TemporaryFolder folder;
  const auto numbers = [&](const std::string& name) {
    return load_texture(folder.file(name), {PictureRole::data, PictureChannels::number}).image->image(0);
  };
  // TGA: blue, green, red, alpha.
  const auto write_tga = [&](const std::string& name, const std::string& pixels) {
    std::string bytes(18, '\0');
    bytes[2] = 2, bytes[12] = 2, bytes[14] = 1, bytes[16] = 32;
    std::ofstream(folder.file(name), std::ios::binary) << bytes << pixels;
  };
  write_tga("holes.tga", {'\0', '\0', '\377', '\377', '\377', '\377', '\377', '\0'});
  CHECK(numbers("holes.tga").pixels == std::vector<Rgb>{{1, 1, 1}, {0, 0, 0}});
  CHECK(load_texture(folder.file("holes.tga"), {PictureRole::color}).image->level(0).at(1, 0) ==
        Rgb{1, 1, 1});
  write_tga("full.tga", {'\0', '\0', '\377', '\377', '\377', '\377', '\377', '\377'});
  CHECK(numbers("full.tga").at(0, 0).g == Approx(1 / 3.0));
  CHECK(numbers("full.tga").at(1, 0).g == 1);
  write_png(folder.file("rgb.png"), {1, 1, {51, 102, 153}});
  CHECK(numbers("rgb.png").at(0, 0).r == Approx(0.4));
  // Two pixels of red: one opaque, one of an alpha of 0; the colour of both is as it stands in the file.
  std::ofstream(folder.file("rgba.png"), std::ios::binary) << rgba_png();
  CHECK(numbers("rgba.png").pixels == std::vector<Rgb>{{1, 1, 1}, {0, 0, 0}});
  CHECK(load_texture(folder.file("rgba.png"), {PictureRole::data}).image->level(0).at(1, 0) == Rgb{1, 0, 0});
}

TEST_CASE("a texture that is missing, broken or too large is magenta, and a warning says why") {
  const TemporaryFolder folder;
  const LoadedTexture missing = load_texture(folder.file("none.png"), {PictureRole::color});
  CHECK(missing.warning ==
        fmt::format("{}: there is no such file; it is shown magenta", folder.file("none.png")));
  CHECK(missing.image->image(0).pixels == std::vector<Rgb>{magenta});
  std::ofstream(folder.file("broken.png")) << "not a picture";
  const LoadedTexture broken = load_texture(folder.file("broken.png"), {PictureRole::data});
  CHECK(broken.warning.starts_with(folder.file("broken.png") + ": "));
  CHECK(broken.image->image(0).pixels == std::vector<Rgb>{magenta});
  // 8193 x 8193 pixels in a few kilobytes: refused by what the header says.
  ByteImage large{8193, 8193, std::vector<std::uint8_t>(std::size_t(3) * 8193 * 8193)};
  write_png(folder.file("large.png"), large);
  const LoadedTexture refused = load_texture(folder.file("large.png"), {PictureRole::color});
  CHECK(refused.warning ==
        fmt::format("{}: 8193 x 8193 pixels; valid are up to 67108864 here; it is shown magenta",
                    folder.file("large.png")));
  CHECK(refused.image->image(0).pixels == std::vector<Rgb>{magenta});
}

}  // namespace twinray::test
