// SPDX-License-Identifier: Apache-2.0
#include "core/visible_pixels.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr int width = 40, height = 30;
constexpr PixelRect all{0, 0, width, height};

int pixel(double place) { return int(std::floor(place)); }

/// At z = 0, looking along -z: the frame at depth d is 2 d wide and 1.5 d high.
Camera camera() { return {.tan_half_width = 1, .tan_half_height = 0.75f}; }

}  // namespace

TEST_CASE("the visible pixels are those around the projected box, and one more") {
  // At depth 4 a pixel is 0.2 wide: the nearer side spans pixels 15 to 30 and 10 to 15.
  const Aabb box{{-1, 0, -5}, {2, 1, -4}};
  CHECK(visible_pixels(camera(), box, {width, height}) == PixelRect{14, 9, 31, 16});
  // Beside the frame: nothing.
  const PixelRect none = visible_pixels(camera(), {{9, 0, -5}, {10, 1, -4}}, {width, height});
  CHECK(none.width() * none.height() == 0);
  // Parallel rays: the frame is 2 wide and 1.5 high at any depth.
  Camera parallel = camera();
  parallel.projection = Projection::orthographic;
  CHECK(visible_pixels(parallel, {{-0.5f, 0, -5}, {0.5f, 0.5f, -4}}, {width, height}) ==
        PixelRect{9, 4, 31, 16});
  const PixelRect empty = visible_pixels(camera(), {}, {width, height});
  CHECK(empty.width() * empty.height() == 0);
}

TEST_CASE("all pixels are visible where the box reaches behind the camera, or the camera has a lens") {
  CHECK(visible_pixels(camera(), {{5, 5, -1}, {6, 6, 1}}, {width, height}) == all);
  CHECK(visible_pixels(camera(), {{5, 5, 1}, {6, 6, 2}}, {width, height}) == all);
  Camera lens = camera();
  lens.lens_radius = 0.1f;
  CHECK(visible_pixels(lens, {{-1, 0, -5}, {2, 1, -4}}, {width, height}) == all);
}

TEST_CASE("no ray through another pixel reaches a point of the box") {
  Random random(11);
  Camera turned = camera();
  turned.position = {1, 2, 3};
  turned.forward = {0, -0.6f, -0.8f};
  turned.up = {0, 0.8f, -0.6f};
  for (int i = 0; i < 2000; ++i) {
    Aabb box;
    for (int corner = 0; corner < 2; ++corner)
      box.extend(turned.position + turned.forward * (2 + 6 * random.unit()) +
                 Vec3{4 * random.unit() - 2, 4 * random.unit() - 2, 4 * random.unit() - 2});
    const PixelRect visible = visible_pixels(turned, box, {width, height});
    const Vec3 p =
        box.lower +
        Vec3{box.extent().x * random.unit(), box.extent().y * random.unit(), box.extent().z * random.unit()} -
        turned.position;
    const float depth = dot(p, turned.forward);
    if (depth <= 0) continue;
    const int x = pixel((1 + dot(p, turned.right) / depth / turned.tan_half_width) / 2 * width);
    const int y = pixel((1 - dot(p, turned.up) / depth / turned.tan_half_height) / 2 * height);
    CAPTURE(x, y, visible.x0, visible.y0, visible.x1, visible.y1);
    CHECK((!contains(all, x, y) || contains(visible, x, y)));
  }
}

TEST_CASE("samples beside their pixel see more, and shifted frames other things") {
  const Aabb box{{-1, 0, -5}, {2, 1, -4}};
  CHECK(visible_pixels(camera(), box, {width, height, all, {3, 2}}) == PixelRect{12, 8, 33, 17});
  // A window beyond the frame: the box beside it is seen there.
  const PixelRect wide{-50, -5, 45, 35};
  CHECK(visible_pixels(camera(), {{-8, 0, -5}, {-4, 1, -4}}, {width, height, wide}) ==
        PixelRect{-21, 9, 5, 16});
  Camera shifted = camera();
  shifted.frame_center = {0.25f, 0.25f};  // By 5 pixels of 40 to the right, and 5 of 30 up.
  CHECK(visible_pixels(shifted, box, {width, height}) == PixelRect{9, 14, 26, 21});
  shifted.projection = Projection::latitude_longitude;
  CHECK(visible_pixels(shifted, box, {width, height}) == all);
}

}  // namespace twinray::test
