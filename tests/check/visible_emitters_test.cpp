// SPDX-License-Identifier: Apache-2.0
#include "check/visible_emitters.h"

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {

TEST_CASE("pixels that see an emitter are those that its light reaches the camera in") {
  Scene scene = scene_of(floor_square(4, 0), {0.5f, 0.5f, 0.5f}, {0, 2, 6}, {0, 1, 0});
  add_lamp(scene, floor_square(0.7f, 0.9f), {3, 3, 3}, EmissionSide::both);
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  const RenderOptions options{.width = 40, .height = 30, .samples = 64, .seed = 9};
  const PixelMask mask = pixels_without_emitters(scene, *engine, options);
  // Without any bounce the picture is what emits, alone.
  const Image emitted =
      mean_image(render(scene, *engine, PathIntegrator(scene, {.max_depth = 0}), options).film);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!is_black(emitted.pixels[i])) CHECK(!mask[i]);
    seen += !mask[i];
  }
  // The mask has more rays a pixel: it finds corners that the picture missed, but no more.
  const auto bright = std::size_t(std::count_if(emitted.pixels.begin(), emitted.pixels.end(),
                                                [](const Rgb& pixel) { return !is_black(pixel); }));
  CHECK(bright > 20);
  CHECK(seen >= bright);
  CHECK(seen <= bright + 8);
}

TEST_CASE("the mask has the size of the part that is rendered") {
  Scene scene = scene_of(floor_square(4, 0), {0.5f, 0.5f, 0.5f}, {0, 2, 6}, {0, 1, 0});
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  const RenderOptions options{.width = 40, .height = 30, .window = PixelRect{3, 4, 13, 9}};
  CHECK(pixels_without_emitters(scene, *engine, options, 4) == PixelMask(50, 1));
}

}  // namespace twinray::test
