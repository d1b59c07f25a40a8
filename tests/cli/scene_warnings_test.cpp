// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_warnings.h"

#include "cli/no_effect.h"
#include "cli/render_command_line.h"

#include "tests/support/catch.h"

namespace twinray::test {
namespace {

using Warnings = std::vector<std::string>;

Warnings warnings_of(const Scene& scene, const std::vector<std::string>& options = {}) {
  std::vector<std::string> words = options;
  words.push_back("scene.dae");
  return scene_warnings(scene, parse_render_arguments(words));
}

Scene lit_scene() {
  Scene scene;
  scene.lights.push_back({"sky", AmbientLight{.radiance = {0, 0, 1}}});
  return scene;
}

}  // namespace

TEST_CASE("a scene of Lambert materials under a light that can be met has no warnings") {
  Scene scene = lit_scene();
  scene.materials.push_back({"clay", Lambert{}});
  CHECK(warnings_of(scene).empty());
  CHECK(warnings_of(scene, {"-H"}).empty());
}

TEST_CASE("a scene without a light is warned of, once, and not where normals are asked for") {
  CHECK(
      warnings_of(Scene{}) ==
      Warnings{"the scene has no light: the picture will be black; --default-light lights it by a soft sky"});
  CHECK(warnings_of(Scene{}, {"--direct=hemisphere"}).size() == 1);
  CHECK(warnings_of(Scene{}, {"--integrator=normals"}).empty());
}

TEST_CASE("pixels of a sky that are brighter than a film takes are counted") {
  auto map = std::make_shared<Image>(2, 1);
  map->pixels = {{5e8f, 0, 0}, {0, 1e9f, 0}};
  Scene scene;
  scene.lights.push_back({"sky", EnvironmentLight{map}});
  CHECK(warnings_of(scene).empty());
  std::get<EnvironmentLight>(scene.lights[0].source).scale = {1, 2, 1};
  CHECK(warnings_of(scene) == Warnings{"\"sky\": pixels brighter than 1e9, which count as that: 1"});
  std::get<EnvironmentLight>(scene.lights[0].source).scale = {3, 2, 1};
  CHECK(warnings_of(scene) == Warnings{"\"sky\": pixels brighter than 1e9, which count as that: 2"});
}

TEST_CASE("lights of radiance 0 are none") {
  const Warnings none{
      "the scene has no light: the picture will be black; --default-light lights it by a soft sky"};
  Image map(2, 1);
  for (const LightSource& dark :
       {LightSource(MeshLight{}), LightSource(SphereLight{}), LightSource(PointLight{}),
        LightSource(SpotLight{}), LightSource(DirectionalLight{}), LightSource(AmbientLight{}),
        LightSource(EnvironmentLight{std::make_shared<const Image>(map)})}) {
    Scene scene;
    scene.lights.push_back({"dark", dark});
    CHECK(warnings_of(scene) == none);
    scene.lights.push_back({"sun", DirectionalLight{.irradiance = {0, 1, 0}}});
    CHECK(warnings_of(scene).empty());
  }
  map.at(1, 0) = {0, 0, 1e-6f};
  Scene sky;
  sky.lights.push_back({"sky", EnvironmentLight{std::make_shared<const Image>(map)}});
  CHECK(warnings_of(sky).empty());
}

TEST_CASE("hemisphere sampling names the delta lights that it cannot find") {
  Scene scene = lit_scene();
  scene.lights.push_back({"sun", DirectionalLight{}});
  CHECK(warnings_of(scene).empty());
  const Warnings one{
      "hemisphere sampling finds no light from a point, a single direction or an invisible shape: \"sun\" "
      "adds nothing to the "
      "picture; --direct=lights would show it"};
  CHECK(warnings_of(scene, {"-H"}) == one);
  Scene hidden = lit_scene();
  hidden.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"bulb", {{{0, 0, 0}, 1}}}});
  hidden.bindings = {{0, 1}};
  hidden.materials = {{"glass", Lambert{}}};
  hidden.lights.push_back({"bulb", SphereLight{0, {1, 1, 1}}});
  CHECK(warnings_of(hidden, {"-H"}).empty());
  hidden.textures = {{"hole", ConstantTexture{{0, 0, 0}}}};
  hidden.bindings[0].alpha = 0;
  CHECK(warnings_of(hidden, {"-H"}).size() == 1);
  CHECK(warnings_of(scene, {"--direct=hemisphere"}) == one);
  CHECK(warnings_of(scene, {"-H", "--integrator=normals"}).empty());
  scene.lights.push_back({"bulb", PointLight{}});
  scene.lights.push_back({"torch", SpotLight{}});
  CHECK(warnings_of(scene, {"-H"}) ==
        Warnings{"hemisphere sampling finds no light from a point, a single direction or an invisible shape: "
                 "\"sun\", "
                 "\"bulb\", \"torch\" add nothing to the picture; --direct=lights would show them"});
}

TEST_CASE("options of lights and surfaces that a scene has not are without effect") {
  Scene scene;
  scene.materials.push_back({"wall", Lambert{}});
  scene.lights.push_back({"sun", DirectionalLight{}});
  const auto found = [&](const std::string& option) {
    return options_without_effect(scene, parse_render_arguments({"scene.dae", option}));
  };
  for (const std::string name : {"--glossy-bounces", "--transmission-bounces", "--regularize"}) {
    scene.materials[0].model = Lambert{};
    const std::string option = name + (name == "--regularize" ? "" : "=1");
    CHECK(found(option) == Warnings{name + ": no effect, for all surfaces of the scene are diffuse"});
    scene.materials[0].model = Mirror{};
    CHECK(found(option).empty());
  }
  CHECK(found("--lenient-environment") ==
        Warnings{"--lenient-environment: no effect, for the scene has no environment"});
  CHECK(found("--attenuation=file") ==
        Warnings{"--attenuation: no effect, for the scene has no point light"});
  scene.lights = {{"bulb", PointLight{}}, {"sky", EnvironmentLight{}}};
  CHECK(found("--lenient-environment").empty());
  CHECK(found("--attenuation=file").empty());
  scene.lights = {{"torch", SpotLight{}}};
  CHECK(found("--attenuation=file").empty());
}

TEST_CASE("light samples have no effect where every light is a point or a direction") {
  Scene scene;
  scene.lights.push_back({"sun", DirectionalLight{}});
  const auto without_effect = [](const Scene& of, std::vector<std::string> words) {
    words.push_back("scene.dae");
    return options_without_effect(of, parse_render_arguments(words));
  };
  CHECK(without_effect(scene, {"-l", "4"}) ==
        Warnings{"--light-samples: no effect, for no light of the scene has an area"});
  CHECK(without_effect(scene, {}).empty());
  CHECK(options_without_effect(scene, parse_render_arguments({"-l", "4", "scene.dae"}),
                               {{"sky", AmbientLight{}}})
            .empty());
  CHECK(without_effect(scene, {"-l", "4", "-H"}).empty());
  scene.lights.push_back({"sky", AmbientLight{}});
  CHECK(without_effect(scene, {"-l", "4"}).empty());
}

TEST_CASE("how one of many lights is chosen has no effect where all are sampled") {
  Scene scene;
  const auto without_effect = [&] {
    return options_without_effect(scene, parse_render_arguments({"--many-lights=power", "scene.dae"}));
  };
  const Warnings none{"--many-lights: no effect, for up to 8 lights of a kind are all sampled"};
  for (int i = 0; i < 8; ++i) {
    scene.lights.push_back({"bulb", PointLight{}});
    scene.lights.push_back({"lamp", SphereLight{}});
    scene.lights.push_back({"sun", DirectionalLight{}});
  }
  CHECK(without_effect() == none);
  scene.lights.push_back({"sun", DirectionalLight{}});
  CHECK(without_effect() == none);
  scene.lights.push_back({"torch", SpotLight{}});
  CHECK(without_effect().empty());
  scene.lights.back() = {"lamp", SphereLight{}};
  CHECK(without_effect().empty());
}

}  // namespace twinray::test
