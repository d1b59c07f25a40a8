// SPDX-License-Identifier: Apache-2.0
// Scenes of others, written and read again.
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

const std::string folder = TWINRAY_SCENES;

/// The reader makes normals unit vectors again.
constexpr float normal_rounding = 1.2e-7f;
/// Of 1 - v, there and back, of coordinates up to 100.
constexpr float v_rounding = 100 * 0x1p-23f;

}  // namespace

TEST_CASE("scenes of the field and of CS184 come back from pbrt's format as they were") {
  for (const char* name :
       {"/field/pbrt/cornell-box/scene-v4.pbrt", "/field/pbrt/veach-mis/scene-v4.pbrt",
        "/field/pbrt/veach-bidir/scene-v4.pbrt", "/field/pbrt/coffee/scene-v4.pbrt", "/cs184/sky/CBbunny.dae",
        "/cs184/sky/CBspheres_lambertian.dae", "/cs184/meshedit/cow.dae"}) {
    INFO(name);
    const Scene scene = load_scene(folder + name).scene;
    const RoundTrip trip = round_trip(scene, "a.pbrt");
    const GeometryDifference apart = difference(scene, trip.scene);
    CHECK(apart.fault == "");
    CHECK(apart.positions == 0);
    CHECK(apart.uvs == 0);
    CHECK_FALSE(apart.has_lost_uvs);
    CHECK(apart.normals <= normal_rounding);
    CHECK(difference(scene.camera, trip.scene.camera) <= 1e-4f);
    if (trip.warnings.empty()) CHECK(first_difference(surfaces(scene), surfaces(trip.scene), 0) == "");
  }
}

TEST_CASE("scenes of the field and of CS184 have the same shapes in glTF, in which light leaves as it did") {
  for (const char* name : {"/field/pbrt/cornell-box/scene-v4.pbrt", "/field/pbrt/coffee/scene-v4.pbrt",
                           "/cs184/sky/CBbunny.dae", "/cs184/meshedit/cow.dae"}) {
    INFO(name);
    const Scene scene = load_scene(folder + name).scene;
    const RoundTrip trip = round_trip(scene, "a.glb", {.instances = InstanceUse::copy});
    const GeometryDifference apart = difference(scene, trip.scene);
    CHECK(apart.fault == "");
    CHECK(apart.positions == 0);
    CHECK(apart.uvs <= v_rounding);
    CHECK(apart.normals <= normal_rounding);
    for (std::size_t i = 0; i < scene.bindings.size() && i < trip.scene.bindings.size(); ++i) {
      const std::uint32_t light = scene.bindings[i].light, read = trip.scene.bindings[i].light;
      REQUIRE((light == no_light) == (read == no_light));
      if (light == no_light) continue;
      CHECK(std::get<MeshLight>(scene.lights[light].source).radiance ==
            std::get<MeshLight>(trip.scene.lights[read].source).radiance);
    }
  }
}

}  // namespace twinray::test
