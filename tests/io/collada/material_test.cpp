// SPDX-License-Identifier: Apache-2.0
#include "io/collada/material.h"

#include "core/error.h"
#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

/// A triangle, or a sphere of radius 1, with the effect's contents.
LoadedScene load_effect(const std::string& effect, bool sphere = false) {
  const std::string shape =
      sphere ? "<library_geometries><geometry id=\"shape\"><extra><technique profile=\"CGL\"><sphere>"
               "<radius>1</radius></sphere></technique></extra></geometry></library_geometries>"
             : collada_triangle();
  return load_collada(
      collada_text(shape + "<library_effects><effect id=\"fx\">" + effect +
                       "</effect></library_effects><library_materials><material id=\"m\" "
                       "name=\"stuff\"><instance_effect url=\"#fx\"/>"
                       "</material></library_materials>",
                   "<node name=\"thing\"><instance_geometry url=\"#shape\"><bind_material><technique_common>"
                   "<instance_material symbol=\"s\" "
                   "target=\"#m\"/></technique_common></bind_material></instance_geometry></node>"));
}

std::string common(const std::string& shading) {
  return "<profile_COMMON><technique>" + shading + "</technique></profile_COMMON>";
}

std::string cgl(const std::string& model) {
  return "<extra><technique profile=\"CGL\">" + model + "</technique></extra>";
}

template <typename Model>
Model only_model(const LoadedScene& loaded) {
  REQUIRE(loaded.scene.materials.size() == 1);
  CHECK(loaded.scene.materials[0].name == "stuff");
  CHECK(loaded.warnings.empty());
  return std::get<Model>(loaded.scene.materials[0].model);
}

}  // namespace

TEST_CASE("every common shading model gives its diffuse color") {
  for (const std::string name : {"phong", "blinn", "lambert"}) {
    const LoadedScene loaded =
        load_effect(common("<" + name + "><diffuse><color>0.25 0.5 0.75 1</color></diffuse></" + name + ">"));
    CHECK(only_model<Lambert>(loaded).reflectance == Rgb{0.25f, 0.5f, 0.75f});
    CHECK(loaded.scene.lights.empty());
  }
}

TEST_CASE("without a diffuse color a surface is black if it is constant or emits, else grey") {
  const auto reflectance = [](const std::string& shading) {
    return only_model<Lambert>(load_effect(common(shading))).reflectance;
  };
  const std::string emission = "<emission><color>3 2 1 1</color></emission>";
  CHECK(reflectance("<constant/>") == Rgb{0, 0, 0});
  CHECK(reflectance("<constant>" + emission + "</constant>") == Rgb{0, 0, 0});
  CHECK(reflectance("<lambert>" + emission + "</lambert>") == Rgb{0, 0, 0});
  CHECK(reflectance("<lambert/>") == Rgb{0.5f, 0.5f, 0.5f});
  CHECK(load_effect(common("<constant>" + emission + "</constant>")).scene.lights.size() == 1);
}

TEST_CASE("a specular color is left out, and noted") {
  const LoadedScene loaded =
      load_effect(common("<phong><diffuse><color>0 0 0</color></diffuse><specular><color>0.5 0.5 0.5 "
                         "1</color></specular></phong>"));
  CHECK(loaded.summary.notes ==
        std::vector<std::string>{
            "materials reflect evenly (Lambert); the specular color of \"stuff\" is left out"});
}

TEST_CASE("a color may be a parameter of its effect") {
  const LoadedScene loaded =
      load_effect("<newparam sid=\"tint\"><float3>0.1 0.2 0.3</float3></newparam>" +
                  common("<lambert><diffuse><param ref=\"tint\"/></diffuse></lambert>"));
  CHECK(only_model<Lambert>(loaded).reflectance == Rgb{0.1f, 0.2f, 0.3f});
}

TEST_CASE("an emission color makes a surface glow on both sides, and it still reflects") {
  const LoadedScene loaded =
      load_effect(common("<phong><emission><color>3 2 1 1</color></emission><diffuse><color>0.5 0.5 0.5 "
                         "1</color></diffuse></phong>"));
  CHECK(only_model<Lambert>(loaded).reflectance == Rgb{0.5f, 0.5f, 0.5f});
  REQUIRE(loaded.scene.lights.size() == 1);
  const auto& light = std::get<MeshLight>(loaded.scene.lights[0].source);
  CHECK(light.radiance == Rgb{3, 2, 1});
  CHECK(light.side == EmissionSide::both);
  CHECK(loaded.scene.lights[0].name == "thing");
  CHECK(loaded.scene.bindings[0].light == 0);
}

TEST_CASE("emission up to 10^9 is read, and more is refused") {
  CHECK_NOTHROW(load_effect(cgl("<emission><radiance>1e9 0 0</radiance></emission>")));
  CHECK_NOTHROW(load_effect(common("<phong><emission><color>1e9 0 0</color></emission></phong>")));
  for (const std::string& effect : {cgl("<emission><radiance>2e9 0 0</radiance></emission>"),
                                    common("<phong><emission><color>2e9 0 0</color></emission></phong>")})
    CHECK_THROWS_AS(load_effect(effect), Error);
}

TEST_CASE("CGL emission reflects nothing") {
  const LoadedScene loaded =
      load_effect(common("<phong><diffuse><color>0.8 0.8 0.8 1</color></diffuse></phong>") +
                  cgl("<emission><radiance>10 10 10</radiance></emission>"));
  CHECK(only_model<Lambert>(loaded).reflectance == Rgb{0, 0, 0});
  CHECK(std::get<MeshLight>(loaded.scene.lights.at(0).source).radiance == Rgb{10, 10, 10});
}

TEST_CASE("a sphere of an emissive material is a sphere light") {
  const LoadedScene loaded = load_effect(cgl("<emission><radiance>1 1 1</radiance></emission>"), true);
  REQUIRE(loaded.scene.lights.size() == 1);
  CHECK(std::get<SphereLight>(loaded.scene.lights[0].source).shape == 0);
  CHECK(loaded.summary.lights[0].power.r == Approx(4 * pi * pi));
}

TEST_CASE("a sphere that is scaled unevenly has the mean radius") {
  const std::string ball =
      "<library_geometries><geometry id=\"ball\"><extra><technique profile=\"CGL\"><sphere><radius>2</radius>"
      "</sphere></technique></extra></geometry></library_geometries>";
  for (const std::string scale : {"1 2 6", "6 1 2", "3 3 3"}) {
    const LoadedScene loaded = load_collada(
        collada_text(ball, "<node><scale>" + scale + "</scale><instance_geometry url=\"#ball\"/></node>"));
    CHECK(loaded.scene.geometry->sphere_set(0)->spheres[0].radius == Approx(6));
    CHECK(loaded.warnings.size() == (scale == "3 3 3" ? 0 : 1));
  }
}

TEST_CASE("mirror, refraction, glass and microfacet are read in full") {
  CHECK(only_model<Mirror>(load_effect(cgl("<mirror><reflectance>1 0.5 0.25</reflectance></mirror>")))
            .reflectance == Rgb{1, 0.5f, 0.25f});

  const auto refraction = only_model<Refraction>(
      load_effect(cgl("<refraction><transmittance>1 1 "
                      "0.5</transmittance><roughness>0.5</roughness><ior>1.25</ior></refraction>")));
  CHECK(refraction.transmittance == Rgb{1, 1, 0.5f});
  CHECK(refraction.roughness == 0.5f);
  CHECK(refraction.ior == 1.25f);

  const auto glass = only_model<Glass>(load_effect(cgl(
      "<glass><reflectance>1 0 1</reflectance><transmittance>0 1 0</transmittance><ior>1.5</ior></glass>")));
  CHECK(glass.reflectance == Rgb{1, 0, 1});
  CHECK(glass.transmittance == Rgb{0, 1, 0});
  CHECK(glass.roughness == 0);
  CHECK(glass.ior == 1.5f);

  const auto gold = only_model<Microfacet>(
      load_effect(cgl("<microfacet><alpha>0.25</alpha><eta>0.5 1 2</eta><k>3 2 1</k></microfacet>")));
  CHECK(gold.alpha == 0.25f);
  CHECK(gold.eta == Rgb{0.5f, 1, 2});
  CHECK(gold.k == Rgb{3, 2, 1});
}

}  // namespace twinray
