// SPDX-License-Identifier: Apache-2.0
// Pictures in each format that is written: what they hold, and that the same picture has the same bytes.
#include "io/picture/output_format.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/picture/image_codec.h"
#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

Image noise(int width, int height) {
  Random random(4);
  Image image(width, height);
  for (Rgb& pixel : image.pixels) {
    const float r = random.uniform(0, 3), g = random.uniform(0, 1), b = random.uniform(0, 0.1f);
    pixel = {r, g, b};
  }
  return image;
}

/// Changes slowly, as JPEG likes it.
Image ramp(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = {float(x) / float(width), float(y) / float(height), 0.5f};
  return image;
}

/// A number of a TIFF file with the least significant byte first.
std::uint32_t number_in(const std::string& file, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(file.at(at + i));
  return value;
}

/// The first value of a field of the first directory; the file is little-endian (TIFF 6.0, section 2).
std::uint32_t field(const std::string& file, std::uint32_t tag) {
  const std::size_t directory = number_in(file, 4, 4);
  for (std::size_t i = 0; i < number_in(file, directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (number_in(file, entry, 2) != tag) continue;
    const std::size_t size = number_in(file, entry + 2, 2) == 3 ? 2 : 4,
                      count = number_in(file, entry + 4, 4);
    return size * count <= 4 ? number_in(file, entry + 8, size)
                             : number_in(file, number_in(file, entry + 8, 4), size);
  }
  FAIL("no field " << tag);
  return 0;
}

}  // namespace

TEST_CASE("a name's ending is its format, and what has another is a PNG") {
  CHECK(output_format("a.EXR") == OutputFormat::exr);
  CHECK(output_format("a.b.jpeg") == OutputFormat::jpeg);
  CHECK(output_format("a.tiff") == OutputFormat::tiff);
  CHECK(output_format("spheres_0.05") == OutputFormat::png);
  CHECK(output_format("-") == OutputFormat::png);
  CHECK(is_linear(OutputFormat::pfm));
  CHECK_FALSE(is_linear(OutputFormat::jpeg));
}

TEST_CASE("a PFM holds the floats of a picture") {
  const TemporaryFolder folder;
  Image image = noise(5, 3);
  image.at(4, 2) = {-1.5f, 1e9f, 1e-20f};
  write_image(folder.file("a.pfm"), image);
  const Image read = read_image(folder.file("a.pfm"));
  REQUIRE(read.width == 5);
  CHECK(std::equal(read.pixels.begin(), read.pixels.end(), image.pixels.begin()));
}

TEST_CASE("an HDR holds what shared exponents have nearest to a picture") {
  const TemporaryFolder folder;
  Image image = noise(40, 30);
  image.at(0, 0) = {0.9999f, 0.5f, 0.001f};  // Its nearest one has the next exponent.
  image.at(1, 0) = {3, -0.5f, 0};
  image.at(2, 0) = {-1, -2, -3};
  image.at(3, 0) = {1e-45f, 0, 1e-40f};
  image.at(4, 0) = {1e9f, 1e3f, 3e8f};
  image.at(5, 0) = {1e-45f, 0, 0};
  write_image(folder.file("a.hdr"), image);
  const Image read = read_image(folder.file("a.hdr"));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgb &wrote = image.pixels[i], &found = read.pixels[i];
    int exponent;  // Of the nearest one.
    std::frexp(max_component(wrote) * (512.0f / 511), &exponent);
    const float half_step = std::ldexp(1.0f, exponent - 9) + 1e-32f;
    const auto is_nearest = [half_step](float given, float read_back) {
      return std::fabs(read_back - std::max(given, 0.0f)) <= half_step;
    };
    REQUIRE((is_nearest(wrote.r, found.r) && is_nearest(wrote.g, found.g) && is_nearest(wrote.b, found.b)));
  }
  CHECK(read.at(0, 0) == Rgb{1, 0.5f, 0});
  CHECK(read.at(1, 0) == Rgb{3, 0, 0});
}

TEST_CASE("OpenImageIO reads HDR pictures, and writes JPEGs and TIFFs, too") {
  CHECK((codec_reads("a.hdr") && codec_writes("a.hdr")));
  for (const std::string name : {"a.jpg", "a.JPEG", "a.tif", "a.TIFF"})
    CHECK((!codec_reads(name) && codec_writes(name)));
  for (const std::string name : {"a.png", "a.exr", "a.pfm", "a.tga", "a.dae", "a", "", "-"})
    CHECK((!codec_reads(name) && !codec_writes(name)));
}

TEST_CASE("a JPEG holds what a display shows, nearly") {
  const TemporaryFolder folder;
  const Image image = ramp(64, 48);
  write_image(folder.file("a.jpg"), image, {{"twinray:seed", "7"}});
  CHECK(read_text(folder.file("a.jpg")).find("twinray:seed: 7") != std::string::npos);
  const Image read = read_image(folder.file("a.jpg"));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    REQUIRE(std::fabs(read.pixels[i].r - image.pixels[i].r) < 0.04f);
    REQUIRE(std::fabs(read.pixels[i].g - image.pixels[i].g) < 0.04f);
  }
}

TEST_CASE("a TIFF holds 32-bit floats, and the metadata in its description") {
  const TemporaryFolder folder;
  const Image image = noise(7, 4);
  write_image(folder.file("a.tif"), image, {{"Software", "ours"}, {"twinray:seed", "7"}});
  const std::string file = read_text(folder.file("a.tif"));
  REQUIRE(file.starts_with(std::string("II*\0", 4)));
  CHECK(field(file, 256) == 7);  // Width, height,
  CHECK(field(file, 257) == 4);
  CHECK(field(file, 258) == 32);  // bits and channels,
  CHECK(field(file, 277) == 3);
  CHECK(field(file, 339) == 3);  // floats, no compression.
  CHECK(field(file, 259) == 1);
  const std::size_t strip = field(file, 273);
  for (std::size_t i = 0; i < 3 * std::size_t(7); ++i) {
    const Rgb& pixel = image.pixels[i / 3];
    CHECK(std::bit_cast<float>(number_in(file, strip + 4 * i, 4)) == (i % 3 == 0   ? pixel.r
                                                                      : i % 3 == 1 ? pixel.g
                                                                                   : pixel.b));
  }
  CHECK(file.find("twinray:seed: 7") != std::string::npos);
}

TEST_CASE(
    "an EXR states the primaries of its colours, and the same picture has the same bytes in each format") {
  const TemporaryFolder folder;
  write_image(folder.file("a.exr"), noise(4, 4));
  const std::string exr = read_text(folder.file("a.exr")), name("chromaticities\0chromaticities\0", 30);
  const std::size_t at = exr.find(name);
  REQUIRE(at != exr.npos);
  CHECK(std::bit_cast<float>(number_in(exr, at + name.size() + 4, 4)) == 0.64f);
  CHECK(std::bit_cast<float>(number_in(exr, at + name.size() + 4 + 28, 4)) == 0.3290f);
  for (const std::string ending : {"png", "jpg", "exr", "tif", "hdr", "pfm"}) {
    CAPTURE(ending);
    for (const std::string file : {"b.", "c."}) write_image(folder.file(file + ending), noise(9, 9));
    CHECK(read_text(folder.file("b." + ending)) == read_text(folder.file("c." + ending)));
  }
}

TEST_CASE("an EXR may hold more than its frame: the data window is larger than the display window") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), noise(14, 10), {}, {-3, -2, 8, 6});
  const std::string file = read_text(folder.file("a.exr"));
  const auto box = [&](const std::string& name) {
    const std::size_t at = file.find(name + std::string("\0box2i\0", 7));
    REQUIRE(at != file.npos);
    std::array<std::int32_t, 4> edges{};
    for (std::size_t i = 0; i < 4; ++i)
      edges[i] = std::int32_t(number_in(file, at + name.size() + 7 + 4 + 4 * i, 4));
    return edges;
  };
  CHECK(box("dataWindow") == std::array{-3, -2, 10, 7});
  CHECK(box("displayWindow") == std::array{0, 0, 7, 5});
  CHECK(read_image(folder.file("a.exr")).pixels == noise(14, 10).pixels);
}

}  // namespace twinray::test
