// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include "tests/support/catch.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// Shape 0 a floor, 1 a lamp of triangles, 2 a sphere lamp; materials and lights of their own.
Scene valid_scene() {
  Scene scene = scene_of(floor_square(1, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 0}, {0, 0, 0});
  add_lamp(scene, floor_square(1, 2), {1, 1, 1}, EmissionSide::both);
  add_lamp(scene, SphereSet{"", {{{0, 3, 0}, 1}}}, {1, 1, 1}, EmissionSide::both);
  return scene;
}

std::string message_of(const Scene& scene) {
  try {
    check_scene(scene);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "valid";
}

}  // namespace

TEST_CASE("a scene whose indices all point somewhere is valid") {
  CHECK(message_of(valid_scene()) == "valid");
}

TEST_CASE("a shape without its own binding, or with an index just out of range, is named") {
  Scene scene = valid_scene();
  scene.bindings[1].material = 3;
  CHECK(message_of(scene) == "shape 1 names material 3; there are 3");
  scene = valid_scene();
  scene.bindings[2].light = 2;
  CHECK(message_of(scene) == "shape 2 names light 2; there are 2");
  scene = valid_scene();
  scene.bindings.pop_back();
  CHECK(message_of(scene) == "3 shapes but 2 bindings");
}

TEST_CASE("a light whose shape is not of its kind is named") {
  Scene scene = valid_scene();
  std::get<MeshLight>(scene.lights[0].source).shape = 2;
  CHECK(message_of(scene) == "light 0 names shape 2, which is not a mesh");
  std::get<MeshLight>(scene.lights[0].source).shape = 3;
  CHECK(message_of(scene) == "light 0 names shape 3, which is not a mesh");
  scene = valid_scene();
  std::get<SphereLight>(scene.lights[1].source).shape = 0;
  CHECK(message_of(scene) == "light 1 names shape 0, which is not a set of one sphere");
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{scene.geometry->shapes()[0], scene.geometry->shapes()[1],
                         SphereSet{"", {{{0, 3, 0}, 1}, {{0, 6, 0}, 1}}}});
  std::get<SphereLight>(scene.lights[1].source).shape = 2;
  CHECK(message_of(scene) == "light 1 names shape 2, which is not a set of one sphere");
}

}  // namespace twinray::test
