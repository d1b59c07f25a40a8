// SPDX-License-Identifier: Apache-2.0
#include "io/collada/shapes.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

/// Two triangles of a geometry; the second one's material emits.
const std::string library =
    collada_mesh(4, "0 0 0 1 0 0 0 1 0 0 0 1",
                 "<triangles material=\"paint\" count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" "
                 "offset=\"0\"/><p>0 1 2</p></triangles><triangles material=\"glow\" count=\"1\"><input "
                 "semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><p>0 1 3</p></triangles>") +
    "<library_effects><effect id=\"red\"><profile_COMMON><technique><lambert><diffuse><color>1 0 0 1</color>"
    "</diffuse></lambert></technique></profile_COMMON></effect><effect "
    "id=\"lamp\"><profile_COMMON><technique>"
    "<constant><emission><color>2 2 2 1</color></emission></constant></technique></profile_COMMON></effect>"
    "</library_effects><library_materials><material id=\"r\"><instance_effect url=\"#red\"/></material>"
    "<material id=\"s\"><instance_effect url=\"#red\"/></material>"
    "<material id=\"l\"><instance_effect url=\"#lamp\"/></material></library_materials>";

std::string node(const std::string& transform, const std::string& paint = "r",
                 const std::string& glow = "l") {
  return "<node>" + transform +
         "<instance_geometry url=\"#shape\"><bind_material><technique_common>"
         "<instance_material symbol=\"paint\" target=\"#" +
         paint + "\"/><instance_material symbol=\"glow\" target=\"#" + glow +
         "\"/></technique_common></bind_material></instance_geometry></node>";
}

LoadedScene load(const std::string& nodes, InstanceUse use = InstanceUse::keep,
                 Interpretation interpretation = Interpretation::standard) {
  LoadOptions options;
  options.instances = use;
  options.interpretation = interpretation;
  return load_collada(collada_text(library, nodes), options);
}

const std::string twice = node("") + node("<translate>5 0 0</translate><scale>-2 2 2</scale>");

}  // namespace

TEST_CASE("a geometry that nodes share is stored once, but for what emits") {
  const LoadedScene kept = load(twice), copied = load(twice, InstanceUse::copy);
  CHECK(kept.summary.instances == 2);
  CHECK(kept.summary.prototypes == 1);
  CHECK(kept.scene.lights.size() == 2);
  CHECK(kept.scene.geometry->triangle_count() == 3);
  CHECK(kept.summary.seen_primitives == copied.scene.geometry->triangle_count());
  CHECK(kept.scene.geometry->bounds() == copied.scene.geometry->bounds());
  CHECK(kept.scene.geometry->instances()[1].to_world.point({1, 0, 0}) == Vec3{3, 0, 0});
  CHECK(load(twice, InstanceUse::automatic).summary.instances == 0);
  for (const InstanceUse use : {InstanceUse::automatic, InstanceUse::keep, InstanceUse::copy}) {
    CHECK(load(twice, use).summary.repeated == 1);
    CHECK(load(twice + twice, use).summary.repeated == 1);
    CHECK(load(node(""), use).summary.repeated == 0);
  }
}

TEST_CASE("instances have one material, and each other binding is a prototype of its own") {
  const LoadedScene loaded =
      load(node("", "r", "s") + node("<translate>1 0 0</translate>", "s", "s") +
           node("<translate>2 0 0</translate>", "r", "s") + node("<translate>3 0 0</translate>", "s", "s"));
  CHECK(loaded.summary.instances == 4);
  CHECK(loaded.summary.prototypes == 2);
  const auto& instances = loaded.scene.geometry->instances();
  CHECK(instances[0].prototype == instances[2].prototype);
  CHECK(instances[1].prototype == instances[3].prototype);
  CHECK(instances[0].prototype != instances[1].prototype);
}

TEST_CASE("what no instance can be is copied, and what reaches too far is an error with its place") {
  const LoadedScene flat = load(node("") + node("<scale>1 1 0.00000001</scale>"));
  CHECK(flat.summary.instances == 1);
  CHECK(flat.scene.geometry->triangle_count() == 4);
  CHECK_THROWS_WITH(load(node("", "r", "s") + node("<translate>2e12 0 0</translate>", "r", "s")),
                    Catch::StartsWith("scene.dae:") && Catch::Contains("this instance reaches to (2e+12,"));
}

TEST_CASE("by CS184's rules everything is a copy") {
  CHECK(load(twice, InstanceUse::keep, Interpretation::cs184).summary.instances == 0);
}

}  // namespace twinray
