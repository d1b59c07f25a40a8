// SPDX-License-Identifier: Apache-2.0
#include "core/scene.h"

#include <fmt/format.h>

#include "core/alpha_test.h"
#include "core/nested_mixes.h"
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

TEST_CASE("mixes in each other are valid up to a depth") {
  Scene scene = valid_scene();
  const auto deepest = [&] { return std::uint32_t(scene.materials.size() - 1); };
  for (int depth = 1; depth <= most_nested_mixes; ++depth)
    scene.materials.push_back({"mix", Mix{0, deepest(), 0.5f}});
  CHECK(message_of(scene) == "valid");
  scene.materials.push_back({"mix", Mix{deepest(), 0, 0.5f}});
  CHECK(message_of(scene) ==
        fmt::format("material {} is a mix in which mixes are {} deep; valid are up to {}", deepest(),
                    most_nested_mixes + 1, most_nested_mixes));
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

TEST_CASE("an alpha, or a map, that names no texture, or a shape that is not cut out by it, is named") {
  Scene scene = valid_scene();
  scene.bindings[1].alpha = 0;
  CHECK(message_of(scene) == "shape 1 names texture 0; there are 0");
  scene.textures = {{"half", ConstantTexture{{0.5f, 0, 0}}}};
  CHECK(message_of(scene) == "shape 1 has an alpha, but its geometry is opaque");
  scene.geometry =
      std::make_shared<const Geometry>(cut_out(scene.geometry->shapes(), scene.bindings, scene.textures));
  CHECK(message_of(scene) == "valid");
  scene.bindings[1].alpha = no_texture;
  CHECK(message_of(scene) == "shape 1 has no alpha, but its geometry is not opaque");
  scene = valid_scene();
  scene.materials[1].normal_map = 0;
  CHECK(message_of(scene) == "material 1 names texture 0; there are 0");
  scene = valid_scene();
  scene.materials[2].bump_map = 4;
  CHECK(message_of(scene) == "material 2 names texture 4; there are 0");
  scene = valid_scene();
  scene.materials[1].tangent_map = 0;
  CHECK(message_of(scene) == "material 1 names texture 0; there are 0");
}

TEST_CASE("an alpha, or a map, by second texture coordinates is refused, however deep it stands") {
  const std::vector<Texture> textures{
      {"first", ImageTexture{std::make_shared<const MipMap>(Image(1, 1, white))}},
      {"second", ImageTexture{.image = std::make_shared<const MipMap>(Image(1, 1, white)),
                              .coordinates = CoordinateSet::second}},
      {"product", ScaleTexture{0, 1}}};
  Scene scene = valid_scene();
  scene.textures = textures;
  scene.materials[1].normal_map = 0;
  CHECK(message_of(scene) == "valid");
  scene.materials[1].normal_map = 2;
  CHECK(message_of(scene) ==
        "material 1 has a map, texture 2, by second texture coordinates; valid are the first ones");
  scene = valid_scene();
  scene.textures = textures;
  scene.bindings[1].alpha = 1;
  CHECK(message_of(scene) ==
        "shape 1 has an alpha, texture 1, by second texture coordinates; valid are the first ones");
}

TEST_CASE("a tangent that is turned too far, and what widens something else, are named") {
  Scene scene = valid_scene();
  scene.materials[0].tangent_degrees = -360;
  CHECK(message_of(scene) == "valid");
  scene.materials[0].tangent_degrees = 361;
  CHECK(message_of(scene) == "material 0 has a tangent turned by 361 degrees; valid are -360 to 360");
  scene.materials[0].tangent_degrees = NAN;
  CHECK(message_of(scene) == "material 0 has a tangent turned by nan degrees; valid are -360 to 360");
  scene = valid_scene();
  scene.textures = {{"half", ConstantTexture{{0.5f, 0, 0}}}};
  scene.materials[1] = {"", Principled{}, {{MaterialInput::roughness, 0, InputMeaning::widening}}};
  CHECK(message_of(scene) ==
        "material 1 has a texture whose meaning is \"widening\" for its roughness; valid is "
        "specular_roughness_anisotropy");
  scene.materials[1].textures[0].input = MaterialInput::specular_roughness_anisotropy;
  CHECK(message_of(scene) == "valid");
  scene.materials[1].textures[0].meaning = InputMeaning::weighted_color;
  CHECK(message_of(scene) ==
        "material 1 has a texture whose meaning is \"weighted_color\" for its specular_roughness_anisotropy; "
        "valid is fuzz_color");
  scene.materials[1].textures[0].input = MaterialInput::fuzz_color;
  CHECK(message_of(scene) == "valid");
}

TEST_CASE("a picture of a mesh light that lies nowhere, or needs smaller copies of itself, is named") {
  Scene scene = valid_scene();
  auto& lamp = std::get<MeshLight>(scene.lights[0].source);
  lamp.picture = std::make_shared<const Image>(1, 1);
  lamp.uv = {{{2, 0, 1}, {0, -1, 0}}}, lamp.filter = TextureFilter::nearest;
  CHECK(message_of(scene) == "valid");
  lamp.uv.m[1][2] = NAN;
  CHECK(message_of(scene) ==
        "light 0 is a mesh light whose picture lies at no place; all six numbers must be finite");
  lamp.uv = {}, lamp.filter = TextureFilter::trilinear;
  CHECK(message_of(scene) ==
        "light 0 is a mesh light whose picture is filtered by mip-maps; valid are nearest and bilinear");
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

TEST_CASE("an environment needs a picture of its layout, a rotation and a scale") {
  Scene scene = valid_scene();
  const auto with = [&scene](EnvironmentLight light) {
    Scene lit = scene;
    add_light(lit, std::move(light));
    return message_of(lit);
  };
  const auto map = std::make_shared<const Image>(4, 2), square = std::make_shared<const Image>(2, 2);
  const Transform turn = Transform::rotation({1, 2, 3}, 50);
  CHECK(with({map, MapLayout::latitude_longitude, turn * Transform::scaling(-1, 1, 1)}) == "valid");
  CHECK(with({square, MapLayout::equal_area}) == "valid");
  CHECK(with({}) == "light 2 is an environment without a picture");
  CHECK(with({map, MapLayout::equal_area}) ==
        "light 2 is an environment whose equal-area picture has 4 x 2 pixels; it must be a square");
  CHECK(with({map, {}, turn * Transform::scaling(1, 1.001, 1)}) ==
        "light 2 is an environment whose rotation also scales or shears");
  CHECK(with({map, {}, turn, {1, -1, 1}}) ==
        "light 2 is an environment whose scale is (1, -1, 1); each must be finite and not negative");
}

TEST_CASE("numbers of lights that lie out of range are named") {
  const auto with = [](LightSource light) {
    Scene lit = valid_scene();
    add_light(lit, std::move(light));
    return message_of(lit);
  };
  const auto picture = std::make_shared<const Image>(4, 2);
  ProjectionLight slide;
  slide.picture = picture;
  CHECK(with(slide) == "valid");
  slide.tan_half_width = 0;
  CHECK(with(slide) ==
        "light 2 is a projection light whose frame is 0 x 1; each must be finite and positive");
  slide.up = {0, 2, 0};
  CHECK(with(slide) == "light 2 is a projection light whose axes are not unit vectors at right angles");
  CHECK(with(ProjectionLight{}) == "light 2 is a projection light without a picture");
  CHECK(with(GoniometricLight{{}, {1, 1, 1}, picture}) ==
        "light 2 is a goniometric light whose equal-area picture has 4 x 2 pixels; it must be a square");
  CHECK(with(GoniometricLight{{}, {-1, 1, 1}, picture, MapLayout::latitude_longitude}) ==
        "light 2 is a goniometric light whose intensity is (-1, 1, 1); each must be finite and not negative");
  CHECK(with(SunLight{{0, -1, 0}, {1, 1, 1}, 180}) ==
        "light 2 is a sun of 180 degrees; valid are more than 0 and less than 180");
  CHECK(with(SunLight{{0, -1, 0}, {1, 1, 1}, 0.5f}) == "valid");
  SpotLight spot;
  spot.falloff_angle_degrees = 60;
  spot.penumbra_degrees = 31;
  CHECK(with(spot) ==
        "light 2 is a spot whose penumbra is 31 degrees wide; valid are 0 to 30, half of its cone");
}

}  // namespace twinray::test
