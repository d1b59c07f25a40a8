// SPDX-License-Identifier: Apache-2.0
#include "io/image_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

Image gradient() {
  Image image(5, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) image.at(x, y) = {0.1f * float(x), 3.7f * float(y), 1e-5f * float(x * y)};
  return image;
}

}  // namespace

TEST_CASE("an EXR keeps every bit") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), gradient(), {{"twinray:seed", "7"}});
  CHECK(read_image(folder.file("a.exr")).pixels == gradient().pixels);
  CHECK(read_text(folder.file("a.exr")).find("twinray:seed") != std::string::npos);
}

TEST_CASE("a PNG keeps every byte, and carries the metadata") {
  const TemporaryFolder folder;
  ByteImage bytes{4, 1, {0, 1, 2, 127, 128, 129, 200, 201, 202, 253, 254, 255}};
  write_png(folder.file("a.png"), bytes, {{"twinray:scene", "the scene"}});
  CHECK(encode_srgb(read_image(folder.file("a.png"))).bytes == bytes.bytes);
  CHECK(read_text(folder.file("a.png")).find("the scene") != std::string::npos);
}

TEST_CASE("the tone curve is sRGB's, clipped and rounded") {
  CHECK(encode_srgb(0.0f) == 0);
  CHECK(encode_srgb(-1.0f) == 0);
  CHECK(encode_srgb(NAN) == 0);
  CHECK(encode_srgb(0.0025f) == 8);  // 255 * 12.92 * 0.0025 = 8.24
  // 127.5 stands for ((0.5 + 0.055) / 1.055)^2.4 = 0.21404114, by IEC 61966-2-1.
  CHECK(encode_srgb(0.2140411f) == 127);
  CHECK(encode_srgb(0.2140412f) == 128);
  CHECK(encode_srgb(1.0f) == 255);
  CHECK(encode_srgb(50.0f) == 255);
}

TEST_CASE("an old file survives a failure to write") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(check_image_output(folder.file("x/a.png")),
                    fmt::format("{}: there is no folder {}", folder.file("x/a.png"), folder.file("x")));
  CHECK_THROWS_WITH(check_image_output(folder.file("a.bmp")),
                    fmt::format("{}: a picture's name must end in .png or .exr", folder.file("a.bmp")));
  std::filesystem::create_directory(folder.path() / "b.png");
  CHECK_THROWS_WITH(check_image_output(folder.file("b.png")),
                    fmt::format("{}: cannot be written: it is a folder", folder.file("b.png")));
}

TEST_CASE("a file that is no picture, or another kind of one, is refused") {
  const TemporaryFolder folder;
  write_text(folder.file("a.exr"), "this is not an EXR");
  CHECK_THROWS_AS(read_image(folder.file("a.exr")), Error);
  CHECK_THROWS_WITH(read_image(folder.file("none.exr")),
                    fmt::format("{}: there is no such file", folder.file("none.exr")));
  CHECK_THROWS_WITH(
      read_image(folder.file("a.tga")),
      fmt::format("{}: not a picture that can be read; valid endings are .exr, .hdr, .png, .jpg",
                  folder.file("a.tga")));
}

TEST_CASE("an EXR cut short is refused") {
  const TemporaryFolder folder;
  Image image(64, 64);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = {float(i), float(i * i % 17), 0.5f};
  write_exr(folder.file("a.exr"), image);
  const std::string whole = read_text(folder.file("a.exr"));
  for (const double part : {0.1, 0.5, 0.9}) {
    write_text(folder.file("b.exr"), whole.substr(0, std::size_t(part * double(whole.size()))));
    CHECK_THROWS_AS(read_image(folder.file("b.exr")), Error);
  }
}

}  // namespace twinray::test
