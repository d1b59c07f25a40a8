// SPDX-License-Identifier: Apache-2.0
#include "io/camera_file.h"

#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

// Looks from (0, 1, 5) along -z, 90 x 60 degrees.
const std::string numbers =
    "90 60 1.5 0.1 100\n0 1 5\n0 1 0\n1.57 0 5 0.5 20\n1 0 0 0 1 0 0 0 1\n800 600 519.6\n4.7 0\n";

std::string message_of(const std::string& text, const TemporaryFolder& folder) {
  write_text(folder.file("cam"), text);
  try {
    load_camera_file(folder.file("cam"), {});
  } catch (const std::exception& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a camera settings file sets field, clip distances, position and axes") {
  const TemporaryFolder folder;
  write_text(folder.file("cam"), numbers);
  Camera scene_camera;
  scene_camera.lens_radius = 0.5f;
  const Camera camera = load_camera_file(folder.file("cam"), scene_camera);
  CHECK(camera.tan_half_width == Approx(1));
  CHECK(camera.tan_half_height == Approx(0.57735));
  CHECK(camera.clip_near == 0.1f);
  CHECK(camera.clip_far == 100);
  CHECK(camera.position == Vec3{0, 1, 5});
  CHECK(camera.forward == Vec3{0, 0, -1});
  CHECK(camera.right == Vec3{1, 0, 0});
  CHECK(camera.lens_radius == 0.5f);
}

TEST_CASE("the rotation's columns are right, up and back") {
  const TemporaryFolder folder;
  std::string turned = numbers;
  turned.replace(turned.find("1 0 0 0 1 0 0 0 1"), 17, "0 0 1 1 0 0 0 1 0");
  write_text(folder.file("cam"), turned);
  const Camera camera = load_camera_file(folder.file("cam"), {});
  CHECK(camera.right == Vec3{0, 1, 0});
  CHECK(camera.up == Vec3{0, 0, 1});
  CHECK(camera.forward == Vec3{-1, 0, 0});
}

TEST_CASE("a broken camera settings file is refused with its place") {
  const TemporaryFolder folder;
  const std::string file = folder.file("cam");
  CHECK(message_of("1 2 3", folder) == file + ": 3 numbers; a camera settings file has 30");
  CHECK(message_of("190" + numbers.substr(2), folder) ==
        file + ":1:1: a field of view lies between 0 and 180 degrees\n  190 60 1.5 0.1 100\n  ^");
  CHECK(message_of("90 60 1.5 5 1" + numbers.substr(17), folder) ==
        file + ":1:11: the clip distances must satisfy 0 <= near < far\n  90 60 1.5 5 1\n            ^");
  std::string skewed = numbers;
  skewed.replace(skewed.find("1 0 0 0 1"), 9, "1 0 0 1 1");
  CHECK(
      message_of(skewed, folder) ==
      file +
          ":5:1: the columns of the camera-to-world rotation are not orthonormal\n  1 0 0 1 1 0 0 0 1\n  ^");
  CHECK(message_of("90 sixty", folder) != "accepted");
  CHECK(message_of(std::string(65537, ' '), folder) ==
        file + ": more than 65536 bytes; a camera settings file has 30 numbers");
  CHECK_THROWS_WITH(load_camera_file(folder.file("none"), {}),
                    folder.file("none") + ": there is no such file");
}

TEST_CASE("a camera is never at a place, nor of a field of view, that is no finite number") {
  const TemporaryFolder folder;
  std::string far = numbers, narrow = numbers;
  far.replace(far.find("0 1 5"), 5, "0 1e13 5");
  narrow.replace(0, 2, "1e-300");
  CHECK(message_of(far, folder).find(":2:1: the camera's position must lie within +-1e+12") !=
        std::string::npos);
  far.replace(far.find("1e13"), 4, "1e99");
  CHECK(message_of(far, folder).find("the camera's position must lie within") != std::string::npos);
  CHECK(message_of(narrow, folder).find(":1:1: this field of view cannot be told from 0") !=
        std::string::npos);
}

}  // namespace twinray::test
