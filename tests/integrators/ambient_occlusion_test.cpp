// SPDX-License-Identifier: Apache-2.0
#include "integrators/ambient_occlusion.h"

#include <cmath>

#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

/// How far the point that the camera sees is from the wall.
constexpr float from_wall = 1;

/// A wide floor, and in the plane x = -1 a wall of this height. The camera sees a point with x = 0.
Scene corner(float wall_height) {
  constexpr float far = 60;
  Mesh mesh = floor_square(far, 0);
  add_triangle(mesh, {-from_wall, 0, -far}, {-from_wall, wall_height, -far}, {-from_wall, wall_height, far});
  add_triangle(mesh, {-from_wall, 0, -far}, {-from_wall, wall_height, far}, {-from_wall, 0, far});
  Scene scene = scene_of(std::move(mesh), {0.2f, 0.3f, 0.4f}, {1, 2, 5}, {0, 0, 5});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-4f;
  return scene;
}

Estimate occlusion(const Scene& scene, float distance, std::uint32_t samples) {
  return estimate_of(
      render_with(scene, AmbientOcclusionIntegrator(scene, distance), small_picture(samples)).film);
}

constexpr float no_limit = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("a floor sees the sky but for what a wall beside it hides, in closed form") {
  // A wall without an end hides half of 1 - cos of the angle under which it rises.
  for (const float height : {0.5f, 1.0f, 4.0f}) {
    CAPTURE(height);
    const double hidden = 0.5 * (1 - from_wall / std::hypot(from_wall, height));
    check_mean(occlusion(corner(height), no_limit, 4096), 1 - hidden, 0.025);
  }
}

TEST_CASE("a wall hides no more than lies within the distance, in closed form") {
  // Of a wall without an upper end: a segment of the disc that the hemisphere projects to.
  for (const float distance : {1.1f, 1.5f, 4.0f}) {
    CAPTURE(distance);
    const double c = from_wall / distance;
    const double hidden = (std::acos(c) - c * std::sqrt(1 - c * c)) / pi;
    check_mean(occlusion(corner(60), distance, 4096), 1 - hidden, 0.025);
  }
  const Estimate open = occlusion(corner(60), 0.99f, 64);
  CHECK(open.mean == 1);
  CHECK(open.standard_error == 0);
}

TEST_CASE("a plate is open on whichever side it is seen from, and nothing at all is black") {
  Scene scene = scene_of(floor_square(1, 0), {}, {0, -3, 0}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  CHECK(occlusion(scene, no_limit, 16).mean == 1);
  scene.camera = camera_at({0, 3, 0}, {0, 6, 0});
  CHECK(occlusion(scene, no_limit, 16).mean == 0);
}

TEST_CASE("from within a closed box there is no sky, unless the walls are beyond the distance") {
  Scene scene = emissive_enclosure(1, 0.5f);
  CHECK(occlusion(scene, no_limit, 16).mean == 0);
  scene.camera = camera_at({0, 0, 0}, {0.1f, 0.05f, -1});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  CHECK(occlusion(scene, 0.5f, 16).mean == 1);
}

TEST_CASE("ambient occlusion has the same bits on every engine and number of threads") {
  const Scene scene = small_room();
  check_engines(scene, AmbientOcclusionIntegrator(scene, 0.7f));
}

}  // namespace twinray::test
