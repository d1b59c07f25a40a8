// SPDX-License-Identifier: Apache-2.0
// Pixels of an environment map that are not radiance, through the program.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/picture/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// Renders the scene of many lights under this sky.
ProcessResult render_under(const TemporaryFolder& folder, const Image& sky, const std::string& options) {
  write_exr(folder.file("sky.exr"), sky);
  return run_program(fmt::format("'" TWINRAY_SOURCE_DIR
                                 "/scenes/lights.dae' -r 16 12 -s 4 -m 1 -q -e '{}' -o '{}' {}",
                                 folder.file("sky.exr"), folder.file("a.exr"), options));
}

Image grey_sky() { return Image(8, 4, {0.5f, 0.5f, 0.5f}); }

}  // namespace

TEST_CASE(
    "an environment with pixels that are not radiance is an error, and a warning where it is let pass") {
  const TemporaryFolder folder;
  Image sky = grey_sky(), repaired = grey_sky();
  sky.at(5, 1) = {1, std::numeric_limits<float>::infinity(), 1};
  sky.at(2, 3) = {-1, 0, 0};
  repaired.at(5, 1) = repaired.at(2, 3) = {};
  const std::string fault = fmt::format(
      "{}: 2 of 8 x 4 pixels are not radiance, the first at column 5, row 1 (from 0): (1, inf, 1); each "
      "component "
      "must lie in [0, 1e+09]",
      folder.file("sky.exr"));

  const ProcessResult strict = render_under(folder, sky, "");
  CHECK(strict.exit_code == 1);
  CHECK(strict.err == "twinray: " + fault + "; with --lenient-environment such pixels are black\n");
  CHECK(folder.file_count() == 1);

  const ProcessResult lenient = render_under(folder, sky, "--lenient-environment");
  CHECK(lenient.exit_code == 0);
  CHECK(lenient.err == "warning: " + fault + "; such pixels are black\n");
  const Image found = read_image(folder.file("a.exr"));
  const ProcessResult expected = render_under(folder, repaired, "--lenient-environment");
  CHECK(expected.err.empty());
  CHECK(found.pixels == read_image(folder.file("a.exr")).pixels);
}

TEST_CASE("a sun of 5 * 10^6 in the environment is not lost") {
  // All of the sky is that bright: each pixel that sees it has its radiance, and no sample is rejected.
  const TemporaryFolder folder;
  Image sky = grey_sky();
  for (Rgb& pixel : sky.pixels) pixel = {5e6f, 1e9f, 1};
  const ProcessResult result = render_under(folder, sky, "--integrator=path -m 0");
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(read_image(folder.file("a.exr")).at(0, 0) == Rgb{5e6f, 1e9f, 1});
}

TEST_CASE("an environment is turned counter-clockwise as seen from above, and made brighter") {
  const TemporaryFolder folder;
  Image sky(8, 4), turned(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      sky.at(x, y) = {float(x), float(y), float(x * y)};
      turned.at((x + 2) % 8, y) = sky.at(x, y) * 3;
    }
  const std::string emission_only = "--view=whole -m 0 ";
  REQUIRE(render_under(folder, turned, emission_only).exit_code == 0);
  const Image expected = read_image(folder.file("a.exr"));
  REQUIRE(render_under(folder, sky, emission_only + "--environment-rotation=90 --environment-scale 3")
              .exit_code == 0);
  const Image seen = read_image(folder.file("a.exr"));
  REQUIRE(seen.pixels.size() == expected.pixels.size());
  float brightest = 0;
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    CHECK(max_component(seen.pixels[i] - expected.pixels[i]) < 1e-3f);
    CHECK(max_component(expected.pixels[i] - seen.pixels[i]) < 1e-3f);
    brightest = std::max(brightest, max_component(seen.pixels[i]));
  }
  CHECK(brightest > 9);  // The sky is seen.
}

TEST_CASE("a panorama is seen as it is, where a latitude-longitude picture is mirrored") {
  const TemporaryFolder folder;
  Image sky(8, 4), mirrored(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) sky.at(x, y) = mirrored.at(7 - x, y) = {float(x), float(y), 1};
  const auto seen = [&](const Image& picture, const std::string& options) {
    REQUIRE(render_under(folder, picture, "--projection=latitude-longitude -m 0 " + options).exit_code == 0);
    return read_image(folder.file("a.exr"));
  };
  const Image expected = seen(mirrored, ""), found = seen(sky, "--environment-layout=panorama");
  REQUIRE(found.pixels.size() == expected.pixels.size());
  for (std::size_t i = 0; i < found.pixels.size(); ++i) {
    CHECK(max_component(found.pixels[i] - expected.pixels[i]) < 1e-3f);
    CHECK(max_component(expected.pixels[i] - found.pixels[i]) < 1e-3f);
  }
  // Red grows to the right of a view all around, but where the picture begins anew.
  const int row = found.height / 4;
  int rising = 0, falling = 0;
  for (int x = 1; x < found.width; ++x) {
    rising += found.at(x, row).r > found.at(x - 1, row).r;
    falling += found.at(x, row).r < found.at(x - 1, row).r;
  }
  CHECK(rising > falling);
  // Turned counter-clockwise as seen from above: to the left.
  Image turned(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) turned.at((x + 6) % 8, y) = sky.at(x, y);
  const std::string as_it_is = "--environment-layout=panorama ";
  const Image before = seen(turned, as_it_is), after = seen(sky, as_it_is + "--environment-rotation=90");
  for (std::size_t i = 0; i < after.pixels.size(); ++i) {
    CHECK(max_component(after.pixels[i] - before.pixels[i]) < 1e-3f);
    CHECK(max_component(before.pixels[i] - after.pixels[i]) < 1e-3f);
  }
}

TEST_CASE("an equal-area environment is a square, and its options need an environment") {
  const TemporaryFolder folder;
  const ProcessResult oblong = render_under(folder, grey_sky(), "--environment-layout=equal-area");
  CHECK(oblong.exit_code == 1);
  CHECK(oblong.err == fmt::format("twinray: {}: 8 x 4 pixels; an equal-area environment is a square\n",
                                  folder.file("sky.exr")));
  Image square(4, 4);
  CHECK(render_under(folder, square, "--environment-layout=equal-area").exit_code == 0);
  const ProcessResult wide = render_under(folder, grey_sky(), "--environment-rotation=361");
  CHECK(wide.exit_code == 2);
  CHECK(wide.err.starts_with("twinray: --environment-rotation: \"361\" is not a number from -360 to 360\n"));
  const ProcessResult none =
      run_program("'" TWINRAY_SOURCE_DIR "/scenes/lights.dae' -r 4 3 -s 1 -q --environment-scale=2 -o '" +
                  folder.file("b.png") + "'");
  CHECK(none.err.find("--environment-scale") != std::string::npos);
  CHECK(none.err.find("for there is no --environment") != std::string::npos);
}

}  // namespace twinray::test
