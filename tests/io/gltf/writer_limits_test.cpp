// SPDX-License-Identifier: Apache-2.0
// Scenes with numbers that glTF has not, or not beside others: what is written can be read.
#include "io/gltf/writer.h"

#include <algorithm>

#include "tests/io/gltf/written.h"
#include "tests/support/catch.h"
#include "tests/support/json.h"
#include "tests/support/round_trip.h"

namespace twinray::test {

TEST_CASE("written gltf: a camera with one clip distance gets another that lies on its other side") {
  Mesh large = triangle();
  for (Vec3& p : large.positions) p = p * 1e6f;
  Scene scene = scene_of(large, Lambert{});
  scene.camera.clip_far = 50;
  const LoadOptions clipped{.clip_as_file = true};
  const RoundTrip near = round_trip(scene, "a.gltf", clipped);
  CHECK(near.scene.camera.clip_far == 50);
  CHECK(near.scene.camera.clip_near < 1);
  CHECK(near.scene.camera.clip_near > 0);
  scene = scene_of(triangle(), Lambert{});
  scene.camera.projection = Projection::orthographic;
  scene.camera.clip_near = 9e6f;
  const RoundTrip far = round_trip(scene, "a.gltf", clipped);
  CHECK(far.scene.camera.clip_near == 9e6f);
  CHECK(far.scene.camera.clip_far > 9e7f);
}

TEST_CASE("written gltf: frames that readers refuse are others, and are named") {
  Scene scene = scene_of(triangle(), Lambert{});
  const auto trip = [&](float width, float height) {
    scene.camera.is_stretched = true;
    scene.camera.tan_half_width = width, scene.camera.tan_half_height = height;
    return round_trip(scene, "a.gltf");
  };
  const std::string named = "the camera's frame is another one: it is too narrow, too wide or too long";
  const auto is_named = [&](const RoundTrip& written) {
    return std::count(written.warnings.begin(), written.warnings.end(), named) == 1;
  };
  const RoundTrip narrow = trip(4e-7f, 3e-7f), wide = trip(4e6f, 3e6f), lengthy = trip(1, 1e-5f);
  CHECK(is_named(narrow));
  CHECK(narrow.scene.camera.tan_half_height == Approx(1e-5f));
  const auto aspect = [](const RoundTrip& written) {
    return nlohmann::json::parse(written.text)["cameras"][0]["perspective"]["aspectRatio"].get<double>();
  };
  CHECK(aspect(narrow) == Approx(4.0 / 3));
  CHECK(is_named(wide));
  CHECK(wide.scene.camera.tan_half_height == Approx(1e5f).epsilon(1e-3));
  CHECK(is_named(lengthy));
  CHECK(aspect(lengthy) == Approx(9999));
  CHECK_FALSE(is_named(trip(1e-3f, 2)));
}

TEST_CASE("written gltf: what emits more than readers take emits as much as they do, in its color") {
  Scene scene = scene_of(triangle(), Lambert{});
  scene.bindings[0].light = 0;
  scene.lights = {{"", MeshLight{0, {5e12f, 2.5e12f, 0}, EmissionSide::front}}};
  const RoundTrip trip = round_trip(scene, "a.gltf");
  CHECK(trip.warnings == std::vector<std::string>{"a surface that emits is 5 x 10^8 bright, and no more"});
  const Rgb radiance = std::get<MeshLight>(trip.scene.lights[0].source).radiance;
  CHECK(radiance.r == Approx(0x1p29));
  CHECK(radiance.g == Approx(0x1p28));
}

}  // namespace twinray::test
