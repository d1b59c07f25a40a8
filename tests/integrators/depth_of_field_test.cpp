// SPDX-License-Identifier: Apache-2.0
// Depth of field against the circle of confusion. What a lens of radius R in focus at the distance F sees of
// a point at the distance d fills, at the distance 1, the lens's own shape scaled by |1/d - 1/F|.
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr int side = 80;
constexpr float half_frame = 0.1f, ball_ratio = 0.004f, lens_radius = 0.2f;

/// A small glowing ball at a distance straight ahead.
Scene glowing_ball(float distance) {
  Scene scene = scene_of(floor_square(1, -9), {0, 0, 0}, {0, 0, 0}, {0, 0, -1});
  add_lamp(scene, SphereSet{"ball", {{{0, 0, -distance}, ball_ratio * distance}}}, {1, 1, 1},
           EmissionSide::front);
  scene.camera.tan_half_width = scene.camera.tan_half_height = half_frame;
  scene.camera.lens_radius = lens_radius;
  return scene;
}

/// The light of a picture: how much, where on the average, how spread and how far out, at the distance 1.
struct Spot {
  double sum = 0, x = 0, y = 0, squared = 0, farthest = 0;
};

Spot spot_of(const Film& film) {
  Spot spot;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double light = film.pixel(x, y).luminance_mean();
      const double across = double(half_frame) * ((x + 0.5) * 2 / side - 1),
                   up = double(half_frame) * (1 - (y + 0.5) * 2 / side);
      spot.sum += light;
      spot.x += light * across;
      spot.y += light * up;
      spot.squared += light * (across * across + up * up);
      if (light > 0) spot.farthest = std::max(spot.farthest, std::hypot(across, up));
    }
  spot.x /= spot.sum;
  spot.y /= spot.sum;
  spot.squared /= spot.sum;
  return spot;
}

Film picture(const Scene& scene) {
  const PathIntegrator path(scene, {.max_depth = 0});
  return render_with(scene, path, {.width = side, .height = side, .samples = 256, .threads = 1}).film;
}

double circle_of_confusion(double distance, double focus) {
  return double(lens_radius) * std::fabs(1 / distance - 1 / focus);
}

/// The mean squared distance from the middle of a regular polygon whose corners are 1 away from it; of a
/// circle for 0 corners.
double polygon_moment(int corners) { return corners == 0 ? 0.5 : (2 + std::cos(2 * M_PI / corners)) / 6; }

/// Of half a million samples, of which some thousands see the ball.
constexpr double noise = 0.02;
constexpr double pixel = 2.0 * half_frame / side;

}  // namespace

TEST_CASE("a small light out of focus fills the circle of confusion, before and behind the plane in focus") {
  for (const auto& [distance, focus] : {std::pair(4.0f, 2.0f), {2.0f, 3.0f}, {2.0f, 10.0f}}) {
    CAPTURE(distance, focus);
    Scene scene = glowing_ball(distance);
    scene.camera.focal_distance = focus;
    const double radius = circle_of_confusion(double(distance), double(focus));
    const Spot spot = spot_of(picture(scene));
    const double of_ball = double(ball_ratio) * double(ball_ratio) / 2, of_pixel = pixel * pixel / 6;
    CHECK(spot.squared == Approx(radius * radius * polygon_moment(0) + of_ball + of_pixel).epsilon(noise));
    CHECK(spot.farthest < radius + 2 * double(ball_ratio) + pixel);
    CHECK(spot.farthest > radius - pixel);
    CHECK(std::hypot(spot.x, spot.y) < noise * radius);
  }
}

TEST_CASE("a light in the plane in focus is sharp, and has as much light as one that is not") {
  Scene scene = glowing_ball(4);
  scene.camera.focal_distance = 4;
  const Spot sharp = spot_of(picture(scene));
  CHECK(sharp.farthest < double(ball_ratio) * 1.1 + pixel);
  scene.camera.focal_distance = 2;
  CHECK(spot_of(picture(scene)).sum == Approx(sharp.sum).epsilon(3 * noise));
}

TEST_CASE("a light out of focus has the shape of the aperture's blades") {
  for (const int blades : {3, 5, 6}) {
    CAPTURE(blades);
    Scene scene = glowing_ball(4);
    scene.camera.focal_distance = 2;
    scene.camera.aperture_blades = blades;
    const double radius = circle_of_confusion(4, 2);
    const Spot spot = spot_of(picture(scene));
    const double of_ball = double(ball_ratio) * double(ball_ratio) / 2, of_pixel = pixel * pixel / 6;
    CHECK(spot.squared ==
          Approx(radius * radius * polygon_moment(blades) + of_ball + of_pixel).epsilon(noise));
  }
}

TEST_CASE("blades stand as they are turned: upright behind the plane in focus, and upside down before it") {
  const auto light = [](float distance, float turns, Vec2 at) {
    Scene scene = glowing_ball(distance);
    scene.camera.focal_distance = 3;
    scene.camera.aperture_blades = 3;
    scene.camera.aperture_turns = turns;
    const double scale = 0.85 * circle_of_confusion(double(distance), 3) / double(half_frame);
    const Film film = picture(scene);
    return film.pixel(int((1 + scale * double(at.x)) * side / 2), int((1 - scale * double(at.y)) * side / 2))
        .luminance_mean();
  };
  CHECK(light(12, 0, {1, 0}) > 0);
  CHECK(light(12, 0, {-1, 0}) == 0);
  CHECK(light(12, 0.25f, {0, 1}) > 0);
  CHECK(light(12, 0.25f, {0, -1}) == 0);
  CHECK(light(2, 0, {1, 0}) == 0);
  CHECK(light(2, 0, {-1, 0}) > 0);
}

}  // namespace twinray::test
