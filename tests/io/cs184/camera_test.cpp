// SPDX-License-Identifier: Apache-2.0
#include "io/cs184/camera.h"

#include <cmath>
#include <fstream>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

/// Positions and axes come from a few roundings to float.
constexpr float view_tolerance = 1e-6f;
constexpr double radians = 3.14159265358979323846 / 180;

const Aabb box{{1, 2, 3}, {3, 8, 6}};  // diagonal 7, middle (2, 5, 4.5)

void check_relative(const Vec3& a, const Vec3& b, float within = view_tolerance) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(max_abs(a - b) <= within * std::max(1.0f, max_abs(b)));
}

Camera towards(double x, double y, double z) {
  Cs184View view;
  view.direction[0] = x, view.direction[1] = y, view.direction[2] = z;
  return cs184_camera(view, box);
}

}  // namespace

TEST_CASE("CS184's camera looks at the middle of the box from one and a half diagonals away") {
  const Camera camera = towards(0, 3, 4);
  check_relative(camera.position, {2, 5 + 10.5f * 0.6f, 4.5f + 10.5f * 0.8f});
  check_relative(camera.forward, {0, -0.6f, -0.8f});
  check_relative(camera.right, {1, 0, 0});
  check_relative(camera.up, {0, 0.8f, -0.6f});
  CHECK(camera.clips_by_distance);
}

TEST_CASE("CS184's camera stands on the side that its direction points to, upright") {
  for (const auto& [x, y, z] : {Vec3{1, 0, 0}, {-1, -2, 0.5f}, {0.1f, 5, -0.3f}, {-3, 0.2f, -1}}) {
    CAPTURE(x, y, z);
    const Camera camera = towards(x, y, z);
    const Vec3 back = normalize(Vec3{x, y, z});
    check_relative(camera.forward, -back);
    check_relative(camera.position, box.center() + back * 10.5f);
    check_relative(cross(camera.right, camera.up), back);
    CHECK(camera.right.y == 0);
    CHECK(camera.up.y > 0);
  }
}

TEST_CASE("CS184's camera that looks straight down is tilted a little, towards +z without a side") {
  const Camera down = towards(0, 2, 0);
  check_relative(down.right, {1, 0, 0});
  check_relative(down.up, {0, 1e-5f, -1});
  CHECK(down.position.z == Approx(4.5 + 10.5e-5).epsilon(1e-7));
  check_relative(towards(1e-12, 2, 0).right, {0, 0, -1});
  check_relative(towards(0, -2, 0).up, {0, 0, 1});
}

TEST_CASE("without a camera CS184's program looks from +z, at angles of 50 and 35 degrees") {
  const Camera camera = cs184_camera({}, box);
  check_relative(camera.position, {2, 5, 15});
  check_relative(camera.forward, {0, 0, -1});
  CHECK(camera.tan_half_width == Approx(std::tan(25 * radians)));
  CHECK(camera.tan_half_height == Approx(std::tan(25 * radians) * 0.75));
  CHECK(camera.clip_near == 0.01f);
  CHECK(camera.clip_far == 100);
  check_relative(cs184_camera({}, {}).position, {0, 0, 1.5f});
}

TEST_CASE("the frame is widened to 4 by 3, and a larger picture shows more") {
  Cs184View view;
  view.tan_half_width = 0.8, view.tan_half_height = 0.3;
  Camera camera = cs184_camera(view, box);
  CHECK(camera.tan_half_width == Approx(0.8));
  CHECK(camera.tan_half_height == Approx(0.6));
  view.tan_half_height = 0.9;
  camera = cs184_camera(view, box);
  CHECK(camera.tan_half_width == Approx(1.2));
  CHECK(camera.tan_half_height == Approx(0.9));
  const Camera same = cs184_frame(camera, 800, 600), small = cs184_frame(camera, 480, 360),
               wide = cs184_frame(camera, 1600, 300);
  CHECK(same.tan_half_width == Approx(1.2));
  CHECK(small.tan_half_width == Approx(1.2 * 0.6));
  CHECK(small.tan_half_height == Approx(0.9 * 0.6));
  CHECK(wide.tan_half_width == Approx(2.4));
  CHECK(wide.tan_half_height == Approx(0.45));
  const Camera fitted = fit_frame(wide, 1600, 300);
  CHECK(fitted.tan_half_width == Approx(wide.tan_half_width));
  CHECK(fitted.tan_half_height == Approx(wide.tan_half_height));
}

TEST_CASE("a camera settings file gives CS184's frame and place, whatever the picture's shape") {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("scene_cam_settings.txt");
  std::ofstream(path) << "90 53.13010235 2 0.5 20\n1 2 3 0 0 0\n1.2 0.3 4 0.1 40\n"
                         "0 0 1\n0 1 0\n-1 0 0\n800 600 300\n4.7 0\n";
  Camera scene_camera = towards(0, 0, 1);
  scene_camera.lens_radius = 0.25f;
  const Camera camera = load_cs184_camera_file(path, scene_camera);
  CHECK(camera.position == Vec3{1, 2, 3});
  CHECK(camera.forward == Vec3{-1, 0, 0});
  CHECK(camera.right == Vec3{0, 0, -1});
  CHECK(camera.clip_near == 0.5f);
  CHECK(camera.clip_far == 20);
  CHECK(camera.clips_by_distance);
  CHECK(camera.lens_radius == 0.25f);
  const Camera fitted = fit_frame(camera, 480, 360);
  CHECK(fitted.tan_half_width == Approx(1));
  CHECK(fitted.tan_half_height == Approx(0.5));
}

}  // namespace twinray
