// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/light_strength.h"

#include <cmath>

#include "core/angle.h"
#include "core/direction_map.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

Image filled(int width, int height, const Rgb& value) {
  Image image(width, height);
  for (Rgb& pixel : image.pixels) pixel = value;
  return image;
}

/// 1 where the map's direction has a z above 0, else 0.
Image upper_half(int side) {
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Vec3 direction = wrapped_direction({(x + 0.5) / side, (y + 0.5) / side});
      if (direction.z > 0) image.at(x, y) = {1, 1, 1};
    }
  return image;
}

}  // namespace

TEST_CASE("a map adds up to its mean over all directions") {
  CHECK(sphere_sum(filled(8, 8, {1, 2, 6}), MapLayout::equal_area) == Approx(4 * pi_double * 3));
  CHECK(sphere_sum(filled(9, 5, {1, 2, 6}), MapLayout::latitude_longitude) == Approx(4 * pi_double * 3));
  // The upper half of latitudes is half of all directions, whatever the pixels' heights.
  Image half = filled(4, 2, {0, 0, 0});
  for (int x = 0; x < 4; ++x) half.at(x, 0) = {1, 1, 1};
  CHECK(sphere_sum(half, MapLayout::latitude_longitude) == Approx(2 * pi_double));
}

TEST_CASE("a frame of even light has the solid angle of its rectangle") {
  for (const auto& [a, b] : {std::pair{0.5, 0.25}, {2.0, 1.0}}) {
    const double solid = 4 * std::asin(a * b / std::sqrt((1 + a * a) * (1 + b * b)));
    CHECK(frame_sum(filled(200, 100, {3, 3, 3}), a, b) == Approx(3 * solid).epsilon(1e-4));
  }
  // Light of one channel counts by its luminance.
  CHECK(frame_sum(filled(1, 1, {0, 2, 0}), 1, 1) == Approx(4 * 2 * 0.7152).epsilon(1e-4));
}

TEST_CASE("the illuminance below a map is half of that below a sky, and comes from above alone") {
  const Transform as_it_is;
  CHECK(illuminance_sum(filled(64, 64, {1, 1, 1}), MapLayout::equal_area, as_it_is) ==
        Approx(pi_double / 2).epsilon(1e-3));
  CHECK(illuminance_sum(upper_half(64), MapLayout::equal_area, as_it_is) ==
        Approx(pi_double / 2).epsilon(1e-3));
  const Transform turned_over{{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}};
  CHECK(illuminance_sum(upper_half(64), MapLayout::equal_area, turned_over) == Approx(0).margin(1e-6));
  const Transform to_z{{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
  CHECK(illuminance_sum(filled(64, 32, {1, 1, 1}), MapLayout::latitude_longitude, to_z) ==
        Approx(pi_double / 2).epsilon(1e-2));
}

TEST_CASE("a light with a picture has pbrt's power, or illuminance, times its color") {
  const test::TemporaryFolder folder;
  write_exr(folder.file("sky.exr"), filled(4, 4, {0.25f, 0.5f, 0.75f}));
  const auto light_of = [&](const std::string& words) {
    test::write_text(folder.file("a.pbrt"), "WorldBegin Shape \"sphere\" LightSource " + words +
                                                " \"string filename\" \"sky.exr\"\n");
    const LoadedScene loaded = load_scene(folder.file("a.pbrt"), {});
    CHECK(loaded.warnings.empty());
    return loaded.scene.lights.at(0).source;
  };
  const auto goniometric = [&](const std::string& words) {
    return std::get<GoniometricLight>(light_of("\"goniometric\" \"rgb I\" [ 2 2 2 ] " + words)).intensity.g;
  };
  CHECK(goniometric("") == 2);
  CHECK(goniometric("\"float power\" -1") == 2);
  CHECK(goniometric("\"float power\" 100") == Approx(2 * 100 / (4 * pi_double * 0.5)));
  const double mean = 0.2126 * 0.25 + 0.7152 * 0.5 + 0.0722 * 0.75;
  const auto environment = [&](const std::string& words) {
    return std::get<EnvironmentLight>(light_of("\"infinite\" \"float scale\" 3 " + words)).scale.b;
  };
  CHECK(environment("") == 3);
  // Of four by four pixels the upper ones' middles stand for them.
  const double unit = illuminance_sum(filled(4, 4, {1, 1, 1}), MapLayout::equal_area, {}) * mean;
  CHECK(environment("\"float illuminance\" 50") == Approx(3 * 50 / unit));
  // Light from above alone, by latitudes, gives a plane what even light does.
  Image above = filled(64, 32, {});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x) above.at(x, y) = {1, 1, 1};
  write_exr(folder.file("sky.exr"), above);
  CHECK(environment("\"float illuminance\" 50") == Approx(3 * 50 / (pi_double / 2)).epsilon(0.01));
  write_exr(folder.file("sky.exr"), filled(4, 4, {0.25f, 0.5f, 0.75f}));
  const auto projection = [&](const std::string& words) {
    return std::get<ProjectionLight>(light_of("\"projection\" \"float fov\" 60 " + words)).intensity.r;
  };
  CHECK(projection("") == 1);
  const double half = std::tan(pi_double / 6);
  CHECK(projection("\"float power\" 7") ==
        Approx(7 / (frame_sum(filled(4, 4, {1, 1, 1}), half, half) * mean)));
}

}  // namespace twinray
