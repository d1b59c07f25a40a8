// SPDX-License-Identifier: Apache-2.0
#include "io/picture/environment_file.h"

#include <fmt/format.h>

#include <limits>
#include <string_view>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// 2 x 1 pixels of 16 bits a channel: 8000 0000 ffff, 2000 0400 c000.
constexpr std::string_view png_of_16_bits{
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00\x00\x01"
    "\x10\x02\x00\x00\x00\x2b\xd0\x34\x9e\x00\x00\x00\x15\x49\x44\x41\x54\x78\xda\x63\x68\x60\x60\x60"
    "\xf8\xff\x5f\x81\x81\x85\xe1\x00\x03\x00\x17\x4e\x03\x63\xda\xba\xbb\xc0\x00\x00\x00\x00\x49\x45"
    "\x4e\x44\xae\x42\x60\x82",
    78};

Image sky() {
  Image image(4, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = {float(i), 0.5f, 1e-3f};
  return image;
}

LoadedEnvironment load(const TemporaryFolder& folder, const Image& image) {
  write_exr(folder.file("sky.exr"), image);
  return load_environment(folder.file("sky.exr"));
}

}  // namespace

TEST_CASE("an environment of radiance is kept as it is, a sun of 10^9 too") {
  const TemporaryFolder folder;
  Image image = sky();
  image.at(2, 1) = {1e9f, 1e9f, 1e9f};
  const LoadedEnvironment loaded = load(folder, image);
  CHECK(loaded.fault.empty());
  CHECK(loaded.map.pixels == image.pixels);
}

TEST_CASE("pixels that are not radiance are counted, the first is named, and all become black") {
  const TemporaryFolder folder;
  Image image = sky(), repaired = sky();
  image.at(3, 1) = {1, infinity, -2};
  image.at(0, 2) = {NAN, 0, 0};
  image.at(1, 2) = {0, 0, -1e-6f};
  image.at(2, 2) = {1.1e9f, 0, 0};
  repaired.at(3, 1) = repaired.at(0, 2) = repaired.at(1, 2) = repaired.at(2, 2) = {};
  const LoadedEnvironment loaded = load(folder, image);
  CHECK(loaded.fault ==
        fmt::format("{}: 4 of 4 x 3 pixels are not radiance, the first at column 3, row 1 (from 0): (1, inf, "
                    "-2); each component must lie in [0, 1e+09]",
                    folder.file("sky.exr")));
  CHECK(loaded.map.pixels == repaired.pixels);
}

TEST_CASE("one wrong component is enough") {
  const TemporaryFolder folder;
  for (const float wrong : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), -1.0f})
    for (int channel = 0; channel < 3; ++channel) {
      Image image = sky();
      Rgb& pixel = image.at(1, 0);
      (channel == 0 ? pixel.r : channel == 1 ? pixel.g : pixel.b) = wrong;
      const LoadedEnvironment loaded = load(folder, image);
      CHECK(loaded.fault.find(": 1 of 4 x 3 pixels is not radiance, the first at column 1, row 0") !=
            std::string::npos);
      CHECK(loaded.map.at(1, 0) == Rgb{});
    }
}

TEST_CASE("an environment that is a part of its frame has its place there, and black around") {
  const TemporaryFolder folder;
  const auto load_in = [&](const ImageFrame& frame) {
    write_exr(folder.file("part.exr"), sky(), {}, frame);
    return load_environment(folder.file("part.exr")).map;
  };
  const Image placed = load_in({2, 1, 8, 4});
  REQUIRE((placed.width == 8 && placed.height == 4));
  CHECK(placed.at(1, 1) == Rgb{});
  CHECK(placed.at(2, 0) == Rgb{});
  CHECK(placed.at(2, 1) == sky().at(0, 0));
  CHECK(placed.at(5, 3) == sky().at(3, 2));
  // Where the frame is another in one number alone.
  for (const ImageFrame& frame : {ImageFrame{1, 0, 4, 3}, {0, 1, 4, 3}, {0, 0, 5, 3}, {0, 0, 4, 4}}) {
    CAPTURE(frame.x, frame.y, frame.width, frame.height);
    const Image framed = load_in(frame);
    REQUIRE((framed.width == frame.width && framed.height == frame.height));
    for (int y = 0; y < framed.height; ++y)
      for (int x = 0; x < framed.width; ++x) {
        const int column = x - frame.x, row = y - frame.y;
        const bool is_there = column >= 0 && column < 4 && row >= 0 && row < 3;
        CHECK(framed.at(x, y) == (is_there ? sky().at(column, row) : Rgb{}));
      }
  }
  CHECK_THROWS_WITH(load_in({0, 0, 1 << 20, 1 << 20}),
                    folder.file("part.exr") + ": 1048576 x 1048576 pixels; valid are up to 2^28");
  const Image cut = load_in({-1, -1, 2, 1});  // More than the frame was rendered.
  REQUIRE((cut.width == 2 && cut.height == 1));
  CHECK(cut.at(0, 0) == sky().at(1, 1));
  CHECK(cut.at(1, 0) == sky().at(2, 1));
}

TEST_CASE("a PNG of 16 bits is sRGB as one of 8 bits is") {
  const TemporaryFolder folder;
  write_text(folder.file("a.png"), std::string(png_of_16_bits));
  const Image image = read_image(folder.file("a.png"));
  REQUIRE(image.width == 2);
  REQUIRE(image.height == 1);
  // ((x / 65535 + 0.055) / 1.055)^2.4, and x / 65535 / 12.92 below 0.04045 (IEC 61966-2-1).
  constexpr double tolerance = 3e-6;  // Of floats, and of the literals below.
  CHECK(image.at(0, 0).r == Approx(0.2140481).epsilon(tolerance));
  CHECK(image.at(0, 0).g == 0);
  CHECK(image.at(0, 0).b == Approx(1).epsilon(tolerance));
  CHECK(image.at(1, 0).r == Approx(0.01435024).epsilon(tolerance));
  CHECK(image.at(1, 0).g == Approx(0.001209384).epsilon(tolerance));
  CHECK(image.at(1, 0).b == Approx(0.5225394).epsilon(tolerance));
}

}  // namespace twinray::test
