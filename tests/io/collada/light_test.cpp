// SPDX-License-Identifier: Apache-2.0
#include "io/collada/light.h"

#include <fmt/format.h>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/near.h"

namespace twinray {
namespace {

LoadedScene load_light(const std::string& body, const std::string& transform = "",
                       const std::string& up_axis = "Y_UP", const LoadOptions& options = {}) {
  return load_collada(
      collada_text(collada_triangle() + "<library_lights><light id=\"lamp\" name=\"Lamp\">" + body +
                       "</light></library_lights>",
                   collada_shape_node() + "<node>" + transform + "<instance_light url=\"#lamp\"/></node>",
                   up_axis),
      options);
}

std::string common_light(const std::string& kind) {
  return "<technique_common>" + kind + "</technique_common>";
}

std::string cgl_light(const std::string& kind) {
  return common_light("<point><color>1 1 1</color></point>") + "<extra><technique profile=\"CGL\">" + kind +
         "</technique></extra>";
}

template <typename Source>
Source only_light(const LoadedScene& loaded) {
  REQUIRE(loaded.scene.lights.size() == 1);
  CHECK(loaded.scene.lights[0].name == "Lamp");
  CHECK(loaded.warnings.empty());
  return std::get<Source>(loaded.scene.lights[0].source);
}

const std::string move = "<translate>1 2 3</translate><rotate>1 0 0 -90</rotate>";  // -z points down

}  // namespace

TEST_CASE("a point light without attenuation follows the physical law") {
  const auto light =
      only_light<PointLight>(load_light(common_light("<point><color>1 2 3</color></point>"), move));
  test::check_near(light.position, {1, 2, 3});
  CHECK(light.intensity == Rgb{1, 2, 3});
  CHECK(light.attenuation.constant == 0);
  CHECK(light.attenuation.linear == 0);
  CHECK(light.attenuation.quadratic == 1);
}

TEST_CASE("with attenuation as in the file, a light without attenuation elements does not fall off") {
  for (const char* kind : {"point", "spot"}) {
    const std::string text = common_light(fmt::format("<{0}><color>1 1 1</color></{0}>", kind));
    const LoadedScene loaded = load_light(text, "", "Y_UP", {.attenuation_as_file = true});
    const auto attenuation = std::visit(
        [](const auto& light) {
          if constexpr (requires { light.attenuation; }) return light.attenuation;
          return Attenuation{};
        },
        loaded.scene.lights[0].source);
    CHECK(attenuation.constant == 1);
    CHECK(attenuation.linear == 0);
    CHECK(attenuation.quadratic == 0);
    CHECK(loaded.summary.notes.empty());
  }
}

TEST_CASE("lights of whose attenuation the file says nothing are named, once each") {
  const std::vector<std::string> said{
      "the file says nothing of how light falls off with the distance d for \"Lamp\": it falls off as 1/d^2, "
      "with d in the file's unit; --attenuation=file gives COLLADA's default, no fall-off"};
  CHECK(load_light(common_light("<point><color>1 1 1</color></point>")).summary.notes == said);
  CHECK(load_light(common_light("<spot><color>1 1 1</color></spot>")).summary.notes == said);
  CHECK(load_light(common_light("<directional><color>1 1 1</color></directional>")).summary.notes.empty());
  CHECK(load_light(common_light(
                       "<point><color>1 1 1</color><quadratic_attenuation>2</quadratic_attenuation></point>"))
            .summary.notes.empty());
  const std::string twice = "</node><node><instance_light url=\"#lamp\"/></node><node>";
  CHECK(load_light(common_light("<point><color>1 1 1</color></point>"), twice).summary.notes == said);
}

TEST_CASE("attenuation is as the file has it, with COLLADA's defaults for the rest") {
  const auto light = only_light<PointLight>(load_light(
      common_light("<point><color>1 1 1</color><linear_attenuation>0.5</linear_attenuation></point>")));
  CHECK(light.attenuation.constant == 1);
  CHECK(light.attenuation.linear == 0.5f);
  CHECK(light.attenuation.quadratic == 0);
}

TEST_CASE("a spot light looks along its node's -z") {
  const auto light = only_light<SpotLight>(load_light(
      common_light("<spot><color>4 4 "
                   "4</color><falloff_angle>60</falloff_angle><falloff_exponent>2</falloff_exponent></spot>"),
      move));
  test::check_near(light.position, {1, 2, 3});
  test::check_near(light.direction, {0, -1, 0});
  CHECK(light.falloff_angle_degrees == 60);
  CHECK(light.falloff_exponent == 2);
  CHECK(light.attenuation.quadratic == 1);
}

TEST_CASE("a light shines along its node's -z, whichever way that is turned") {
  const std::string body = common_light("<directional><color>1 1 1</color></directional>");
  const auto direction = [&](const std::string& rotation) {
    return only_light<DirectionalLight>(load_light(body, rotation)).direction;
  };
  test::check_near(direction(""), {0, 0, -1});
  test::check_near(direction("<rotate>0 1 0 90</rotate>"), {-1, 0, 0});
  test::check_near(direction("<rotate>1 0 0 90</rotate>"), {0, 1, 0});
}

TEST_CASE("a directional light's translation and scale do not matter") {
  const std::string body = common_light("<directional><color>1 1 1</color></directional>");
  for (const std::string extra : {"", "<scale>5 6 7</scale>"})
    test::check_near(only_light<DirectionalLight>(load_light(body, move + extra)).direction, {0, -1, 0});
}

TEST_CASE("an ambient light comes from around up, whatever the file's up axis") {
  for (const std::string axis : {"X_UP", "Y_UP", "Z_UP"}) {
    const auto light = only_light<AmbientLight>(
        load_light(common_light("<ambient><color>1 1 1</color></ambient>"), move, axis));
    CHECK(light.up == Vec3{0, 1, 0});
    CHECK(light.radiance == Rgb{1, 1, 1});
  }
}

TEST_CASE("an area light is its node's unit square, and shines along -z from its front") {
  for (const std::string mirror : {"1", "-1"}) {
    const LoadedScene loaded = load_light(cgl_light("<area><color>5 6 7</color></area>"),
                                          move + "<scale>" + mirror + " 1 1</scale><scale>4 2 1</scale>");
    const auto light = only_light<MeshLight>(loaded);
    CHECK(light.radiance == Rgb{5, 6, 7});
    CHECK(light.side == EmissionSide::front);
    CHECK(loaded.scene.bindings[light.shape].light == 0);
    const Mesh& mesh = mesh_of(loaded, light.shape);
    REQUIRE(mesh.triangles.size() == 2);
    float area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      test::check_near(normalize(n), {0, -1, 0});
      area += length(n) / 2;
    }
    CHECK(area == Approx(8));
    Vec3 center;
    for (const Vec3& p : mesh.positions) center += p * 0.25f;
    test::check_near(center, {1, 2, 3});
    const auto& material = loaded.scene.materials[loaded.scene.bindings[light.shape].material];
    CHECK(std::get<Lambert>(material.model).reflectance == Rgb{0, 0, 0});
  }
}

TEST_CASE("an area light that its node flattens is left out with a warning") {
  const LoadedScene loaded =
      load_light(cgl_light("<area><color>5 5 5</color></area>"), "<scale>1 0 1</scale>");
  CHECK(loaded.scene.lights.empty());
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message ==
        "the transform of this area light's node leaves it no area; it is left out");
}

TEST_CASE("radiance and irradiance up to 10^9 are read, and more is refused") {
  for (const std::string kind : {"area", "directional", "ambient"}) {
    const auto of = [&](const std::string& value) {
      return load_light(cgl_light("<" + kind + "><color>1 1 " + value + "</color></" + kind + ">"));
    };
    CHECK(of("1e9").scene.lights.size() == 1);
    CHECK_THROWS_AS(of("1.001e9"), Error);
  }
  CHECK_NOTHROW(load_light(common_light("<point><color>1e12 1 1</color></point>")));
}

TEST_CASE("a CGL kind stands before the common one") {
  const auto light =
      only_light<DirectionalLight>(load_light(cgl_light("<directional><color>2 2 2</color></directional>")));
  CHECK(light.irradiance == Rgb{2, 2, 2});
}

}  // namespace twinray
