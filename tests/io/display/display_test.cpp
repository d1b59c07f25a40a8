// SPDX-License-Identifier: Apache-2.0
// From light to what a display shows.
#include "io/display/display.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/error.h"
#include "io/display/agx.h"
#include "io/display/white_balance.h"
#include "io/pbrt/spectrum.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

Image one_pixel(const Rgb& color) {
  Image image(1, 1);
  image.at(0, 0) = color;
  return image;
}

std::vector<std::uint8_t> bytes_of(const Rgb& color, const Display& display) {
  return displayed(one_pixel(color), display).bytes;
}

/// A configuration of OpenColorIO whose one view halves all colours.
constexpr const char* configuration = R"(ocio_profile_version: 1
roles: {default: raw, scene_linear: lin_srgb, reference: lin_srgb}
displays:
  screen:
    - !<View> {name: Half, colorspace: half}
active_displays: []
active_views: []
colorspaces:
  - !<ColorSpace> {name: lin_srgb}
  - !<ColorSpace> {name: raw, isdata: true}
  - !<ColorSpace>
    name: half
    from_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)";

/// $OCIO, as long as this lives.
class Configured {
 public:
  explicit Configured(const std::string& path) { setenv("OCIO", path.c_str(), 1); }
  ~Configured() { unsetenv("OCIO"); }
};

std::string message_of(const Display& display) {
  try {
    displayed(one_pixel({1, 1, 1}), display);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("colours go to XYZ and back, and sRGB's matrix is the one of its standard") {
  const ColorMatrix m = to_xyz(srgb_primaries);  // IEC 61966-2-1
  CHECK(m[0][0] == Approx(0.4124).margin(1e-4));
  CHECK(m[1][0] == Approx(0.2126).margin(1e-4));
  CHECK(m[1][1] == Approx(0.7152).margin(1e-4));
  CHECK(m[2][2] == Approx(0.9505).margin(1e-4));
  const ColorMatrix same = product(inverse(m), m);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) CHECK(same[i][j] == Approx(i == j).margin(1e-12));
}

TEST_CASE("without options a display has the picture as it is, in sRGB") {
  CHECK(bytes_of({0.2140412f, 2, -1}, {}) == std::vector<std::uint8_t>{128, 255, 0});
}

TEST_CASE("a stop of exposure doubles the light") {
  CHECK(bytes_of({0.1f, 0.2f, 0.3f}, {.exposure_stops = 1}) == bytes_of({0.2f, 0.4f, 0.6f}, {}));
  CHECK(bytes_of({0.4f, 0.2f, 0.8f}, {.exposure_stops = -2}) == bytes_of({0.1f, 0.05f, 0.2f}, {}));
}

TEST_CASE("white balance makes the light of a black body white, with its luminance") {
  for (const double kelvin : {2000.0, 2856.0, 4000.0, 6500.0, 25000.0}) {
    CAPTURE(kelvin);
    const Rgb balanced = transformed(white_balance(blackbody_color(kelvin)), blackbody_color(kelvin));
    CHECK(balanced.r == Approx(1).margin(1e-5));
    CHECK(balanced.g == Approx(1).margin(1e-5));
    CHECK(balanced.b == Approx(1).margin(1e-5));
  }
  // What was white beside a lamp's red light is blue beside white. Daylight changes little.
  const Rgb cool = transformed(white_balance(blackbody_color(2856)), Rgb{1, 1, 1}),
            day = transformed(white_balance(blackbody_color(6500)), Rgb{1, 1, 1});
  CHECK(cool.b > 2 * cool.r);
  for (const float channel : {day.r, day.g, day.b}) CHECK(channel == Approx(1).margin(0.05));
  CHECK(bytes_of(blackbody_color(3000) * 0.25f, {.white_kelvin = 3000}) ==
        bytes_of({0.25f, 0.25f, 0.25f}, {}));
}

TEST_CASE("the daylight that a scene's file names is white, unless another white is asked for") {
  for (const double kelvin : {2000.0, 4500.0, 7504.0, 25000.0})
    CHECK(bytes_of(daylight_color(kelvin) * 0.25f, {.daylight_kelvin = kelvin}) ==
          bytes_of({0.25f, 0.25f, 0.25f}, {}));
  const Rgb grey{0.25f, 0.25f, 0.25f};
  CHECK(bytes_of(grey, {.white_kelvin = 3000, .daylight_kelvin = 9000}) ==
        bytes_of(grey, {.white_kelvin = 3000}));
  CHECK(bytes_of(grey, {.daylight_kelvin = 9000}) != bytes_of(grey, {}));
}

TEST_CASE("AgX's curve begins at 0, has middle grey in its middle with the slope 2, and ends at 1") {
  constexpr double pivot = 10 / 16.5;
  CHECK(agx_curve(0) == Approx(0).margin(1e-12));
  CHECK(agx_curve(pivot) == Approx(0.5));
  CHECK(agx_curve(1) == Approx(1));
  CHECK((agx_curve(pivot + 1e-4) - agx_curve(pivot - 1e-4)) / 2e-4 == Approx(2).epsilon(1e-3));
  for (int i = 0; i < 100; ++i) CHECK(agx_curve(i / 100.0) < agx_curve((i + 1) / 100.0));
}

TEST_CASE(
    "AgX keeps grey grey, shows middle grey at half of a display's code, and lets bright colours go white") {
  const Agx agx;
  for (const float grey : {0.001f, 0.18f, 1.0f, 20.0f}) {
    const Rgb shown = agx.displayed({grey, grey, grey});
    CHECK(shown.g == Approx(shown.r).margin(1e-6));
    CHECK(shown.b == Approx(shown.r).margin(1e-6));
  }
  CHECK(agx.displayed({0.18f, 0.18f, 0.18f}).g == Approx(std::pow(0.5, 2.2)).epsilon(1e-4));
  CHECK(agx.displayed({0, 0, 0}).g == Approx(0).margin(1e-6));
  CHECK(agx.displayed({-1, -1, -1}).g == Approx(0).margin(1e-6));
  CHECK(agx.displayed({1e6f, 1e6f, 1e6f}).g == Approx(1).margin(1e-5));
  // Blue light: dark it stays blue, bright it loses its colour.
  const Rgb dim = agx.displayed({0, 0, 0.2f}), bright = agx.displayed({0, 0, 200});
  CHECK(dim.b > 25 * dim.g);
  CHECK(bright.g > 0.5f * bright.b);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Rgb shown = agx.displayed({30 * random.unit(), 3 * random.unit(), random.unit() - 0.2f});
    for (const float channel : {shown.r, shown.g, shown.b}) {
      REQUIRE(channel >= 0);
      REQUIRE(channel <= 1);
    }
  }
  CHECK(bytes_of({0.18f, 0.18f, 0.18f}, {.tone = Tone::agx})[0] == encode_srgb(float(std::pow(0.5, 2.2))));
}

TEST_CASE("a view of OpenColorIO's is that of the configuration, and others are named with what there is") {
  const TemporaryFolder folder;
  std::ofstream(folder.file("config.ocio")) << configuration;
  CHECK(message_of({.ocio_view = "Half"}) == "$OCIO names no configuration of OpenColorIO");
  const Configured configured(folder.file("config.ocio"));
  CHECK(bytes_of({1, 0.2f, 7}, {.ocio_view = "Half"}) == std::vector<std::uint8_t>{128, 26, 255});
  CHECK(bytes_of({1, 0.2f, 7}, {.exposure_stops = -1, .ocio_display = "screen", .ocio_view = "Half"}) ==
        std::vector<std::uint8_t>{64, 13, 255});
  CHECK(message_of({.ocio_view = "Film"}) ==
        "the configuration of $OCIO has no view \"Film\" of the display \"screen\"; valid are Half");
  CHECK(message_of({.ocio_display = "wall", .ocio_view = "Half"}) ==
        "the configuration of $OCIO has no display \"wall\"; valid are screen");
  const Configured broken(folder.file("none.ocio"));
  CHECK(message_of({.ocio_view = "Half"}).find("none.ocio") != std::string::npos);
}

}  // namespace twinray::test
