// SPDX-License-Identifier: Apache-2.0
#include "io/collada/lamp.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

/// A box lamp as CS184 writes it: an area light of 0.6 x 0.8 at the height 1.49 that shines down (z is up),
/// and an emissive mesh of 0.8 x 0.6 in the same place, moved by `shift` and wound to face up or down.
std::string lamp_scene(const std::string& shift, const std::string& winding, const std::string& light) {
  return collada_text(
      collada_mesh(
          4, "-0.4 -0.3 0 0.4 -0.3 0 0.4 0.3 0 -0.4 0.3 0",
          "<triangles count=\"2\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><p>" +
              winding + "</p></triangles>") +
          "<library_lights><light id=\"l\" name=\"Area\">" + light +
          "</light></library_lights><library_effects><effect id=\"fx\"><extra><technique "
          "profile=\"CGL\"><emission>"
          "<radiance>7 7 "
          "7</radiance></emission></technique></extra></effect></library_effects><library_materials>"
          "<material id=\"m\"><instance_effect url=\"#fx\"/></material></library_materials>",
      "<node name=\"mesh\"><translate>" + shift +
          "</translate><instance_geometry url=\"#shape\"><bind_material><technique_common>"
          "<instance_material symbol=\"m\" "
          "target=\"#m\"/></technique_common></bind_material></instance_geometry></node>"
          "<node><translate>0 0 1.49</translate><scale>0.6 0.8 1</scale><instance_light url=\"#l\"/></node>",
      "Z_UP");
}

const std::string up = "0 1 2 0 2 3", down = "0 2 1 0 3 2", mixed = "0 1 2 0 3 2";
const std::string area_lamp =
    "<technique_common><point><color>3 3 3</color></point></technique_common><extra><technique "
    "profile=\"CGL\"><area>"
    "<color>10 9 8</color></area></technique></extra>";
const std::string point = "<technique_common><point><color>3 3 3</color></point></technique_common>";

}  // namespace

TEST_CASE("where an area light and an emissive mesh coincide the mesh is the lamp") {
  for (const std::string& winding : {up, down}) {
    const LoadedScene loaded = load_collada(lamp_scene("0 0.004 1.49001", winding, area_lamp));
    REQUIRE(loaded.scene.lights.size() == 1);
    const auto& lamp = std::get<MeshLight>(loaded.scene.lights[0].source);
    CHECK(lamp.shape == 0);
    CHECK(lamp.radiance == Rgb{10, 9, 8});
    CHECK(lamp.side == (winding == down ? EmissionSide::front : EmissionSide::back));
    CHECK(loaded.scene.geometry->triangle_count() == 2);
    CHECK(loaded.summary.notes ==
          std::vector<std::string>{
              "one lamp: the area light \"Area\" and the emissive mesh \"mesh\" coincide; the mesh "
              "is the lamp, with the area light's color and side"});
    CHECK(loaded.warnings.empty());
    CHECK(loaded.summary.has_double_lamps);
  }
}

TEST_CASE("lamps that do not coincide are both kept") {
  // Off the plane, off the centre, or facing both ways.
  const std::string apart[][2] = {{"0 0 1.488", down}, {"0 0.01 1.49", down}, {"0 0 1.49", mixed}};
  for (const auto& [shift, winding] : apart) {
    INFO(shift << ", " << winding);
    const LoadedScene loaded = load_collada(lamp_scene(shift, winding, area_lamp));
    CHECK(loaded.scene.lights.size() == 2);
    CHECK(std::get<MeshLight>(loaded.scene.lights[0].source).side == EmissionSide::both);
    CHECK(loaded.summary.notes.empty());
    CHECK_FALSE(loaded.summary.has_double_lamps);
  }
}

TEST_CASE("a point light within an emissive mesh is left out, and the mesh keeps its color") {
  const LoadedScene loaded = load_collada(lamp_scene("0 0.004 1.49", down, point));
  REQUIRE(loaded.scene.lights.size() == 1);
  CHECK(std::get<MeshLight>(loaded.scene.lights[0].source).radiance == Rgb{7, 7, 7});
  CHECK(loaded.summary.notes ==
        std::vector<std::string>{
            "one lamp: the point light \"Area\" lies within the emissive mesh \"mesh\"; the mesh is "
            "the lamp, and the point light is left out"});
  CHECK(loaded.summary.has_double_lamps);
  CHECK_FALSE(load_collada(lamp_scene("0 0 1.48", down, point)).summary.has_double_lamps);
  CHECK(load_collada(lamp_scene("0 0 1.48", down, point)).scene.lights.size() == 2);
  CHECK(load_collada(lamp_scene("0.5 0 1.49", down, point)).scene.lights.size() == 2);
}

TEST_CASE("on request both lamps are kept") {
  const LoadOptions keep{.keep_both_lamps = true};
  for (const std::string& light : {area_lamp, point}) {
    const LoadedScene loaded = load_collada(lamp_scene("0 0 1.49", down, light), keep);
    CHECK(loaded.scene.lights.size() == 2);
    CHECK(loaded.summary.has_double_lamps);
  }
  CHECK_FALSE(load_collada(lamp_scene("0 0 1.48", down, point), keep).summary.has_double_lamps);
}

}  // namespace twinray
