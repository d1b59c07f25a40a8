// SPDX-License-Identifier: Apache-2.0
// What CS184's rules make of a file, beside its picture of normals (cs184_agreement_test.cpp).
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

const LoadOptions cs184{.interpretation = Interpretation::cs184};

std::string light(const std::string& kind, const std::string& extra = "") {
  return "<library_lights><light id=\"light\"><technique_common>" + kind + "</technique_common>" + extra +
         "</light></library_lights>";
}

std::string instance(const std::string& transform) {
  return "<node>" + transform + "<instance_light url=\"#light\"/></node>";
}

LoadedScene load_cs184_light(const std::string& kind, const std::string& transform,
                             const std::string& extra = "") {
  return load_collada(
      collada_text(collada_triangle() + light(kind, extra), collada_shape_node() + instance(transform)),
      cs184);
}

const std::string triangles = "<input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><p>0 1 2</p>";

}  // namespace

TEST_CASE("by CS184's rules a point light does not fall off") {
  const LoadedScene loaded =
      load_cs184_light("<point><color>1 2 3</color><quadratic_attenuation>4</quadratic_attenuation></point>",
                       "<translate>1 2 3</translate>");
  const auto& point = std::get<PointLight>(loaded.scene.lights.at(0).source);
  CHECK(point.position == Vec3{1, 2, 3});
  CHECK(point.intensity == Rgb{1, 2, 3});
  CHECK(point.attenuation.constant == 1);
  CHECK(point.attenuation.linear == 0);
  CHECK(point.attenuation.quadratic == 0);
}

TEST_CASE("by CS184's rules a directional light comes from the point in front of its node") {
  const LoadedScene loaded =
      load_cs184_light("<directional><color>1 1 1</color></directional>", "<translate>3 0 5</translate>");
  const auto& sun = std::get<DirectionalLight>(loaded.scene.lights.at(0).source);
  CHECK(length(sun.direction - Vec3{-0.6f, 0, -0.8f}) < 1e-6f);
  CHECK(load_cs184_light("<directional><color>1 1 1</color></directional>", "").scene.lights.size() == 1);
  const std::string text =
      collada_text(collada_triangle() + light("<directional><color>1 1 1</color></directional>"),
                   collada_shape_node() + instance("<translate>0 0 1</translate>"));
  CHECK(collada_error(text, cs184)
            .find("by CS184's rules this light comes from the point one unit in front of "
                  "its node, and that is the origin: it has no direction") != std::string::npos);
}

TEST_CASE("by CS184's rules a spot light is left out") {
  const LoadedScene loaded = load_cs184_light("<spot><color>1 1 1</color></spot>", "");
  CHECK(loaded.scene.lights.empty());
  CHECK(messages(loaded) ==
        std::vector<std::string>{"a spot light gives no light in CS184's program; it is left out"});
}

TEST_CASE("surfaces alone are the scene without lights and what area lights add to it") {
  const std::string area =
      "<extra><technique profile=\"CGL\"><area><color>1 1 1</color></area></technique></extra>";
  const std::string text =
      collada_text(collada_triangle() + light("<point><color>1 1 1</color></point>", area),
                   collada_shape_node() + instance(""));
  const LoadedScene whole = load_collada(text, cs184);
  CHECK(whole.scene.lights.size() == 1);
  CHECK(whole.scene.geometry->triangle_count() == 3);
  LoadOptions options = cs184;
  options.surfaces_only = true;
  const LoadedScene surfaces = load_collada(text, options);
  CHECK(surfaces.scene.lights.empty());
  CHECK(surfaces.scene.geometry->triangle_count() == 1);
  CHECK(surfaces.scene.camera.position == whole.scene.camera.position);
}

TEST_CASE("by CS184's rules a node has one object, and what else it has is named") {
  const std::string libraries = collada_triangle() + light("<point><color>1 1 1</color></point>");
  const LoadedScene loaded = load_collada(
      collada_text(libraries,
                   collada_shape_node() +
                       "<node><instance_geometry url=\"#shape\"/><instance_light url=\"#light\"/></node>"),
      cs184);
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(loaded.scene.lights.size() == 1);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].place.excerpt.find("instance_geometry") != std::string::npos);
  CHECK(
      loaded.warnings[0].message ==
      "a node has one object in CS184's program, its camera, else its light, else its geometry; this one is "
      "left out");
}

TEST_CASE("by CS184's rules a mesh has one polylist, else one list of triangles") {
  const std::string polylist =
                        "<polylist count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" "
                        "offset=\"0\"/><vcount>3</vcount><p>0 2 1</p></polylist>",
                    list = "<triangles count=\"1\">" + triangles + "</triangles>",
                    strips = "<tristrips count=\"1\">" + triangles + "</tristrips>";
  const auto count = [](const std::string& lists) {
    const LoadedScene loaded =
        load_collada(collada_text(collada_mesh(3, "0 0 0 1 0 0 0 1 0", lists), collada_shape_node()), cs184);
    return std::pair{loaded.scene.geometry->triangle_count(), loaded.warnings.size()};
  };
  CHECK(count(list + polylist) == std::pair<std::size_t, std::size_t>{1, 1});
  CHECK(count(polylist + polylist) == std::pair<std::size_t, std::size_t>{1, 1});
  CHECK(count(list + strips) == std::pair<std::size_t, std::size_t>{1, 1});
  CHECK(count(strips) == std::pair<std::size_t, std::size_t>{1, 0});
}

TEST_CASE("by CS184's rules a file's normals do not count") {
  const std::string normals =
      collada_source("normals", 1, "1 0 0") +
      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/><input "
      "semantic=\"NORMAL\" source=\"#normals\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>";
  const std::string text = collada_text(collada_mesh(3, "0 0 0 1 0 0 0 1 0", normals), collada_shape_node());
  CHECK(mesh_of(load_collada(text)).normals.at(0) == Vec3{1, 0, 0});
  const LoadedScene loaded = load_collada(text, cs184);
  for (const Vec3& normal : mesh_of(loaded).normals) CHECK(normal == Vec3{0, 0, -1});
}

TEST_CASE("a mirrored node turns the fronts of its triangles by CS184's rules") {
  const std::string node = collada_shape_node("<scale>-1 1 1</scale>");
  const auto front = [&](const LoadOptions& options) {
    return load_collada(collada_text(collada_triangle(), node), options).scene.geometry->facet(0, 0).normal.z;
  };
  CHECK(front({}) == 1);
  CHECK(front(cs184) == -1);
}

TEST_CASE("by CS184's rules a node's first matrix is the last of its transforms") {
  const std::string transform =
      "<translate>1 0 0</translate><matrix>1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1</matrix><translate>4 0 "
      "0</translate>";
  const auto left = [&](const LoadOptions& options) {
    return load_collada(collada_text(collada_triangle(), collada_shape_node(transform)), options)
        .scene.geometry->bounds()
        .lower.x;
  };
  CHECK(left({}) == 7);
  CHECK(left(cs184) == 3);
}

TEST_CASE("a camera from whose front the origin is seen nowhere looks from +z by CS184's rules") {
  const std::string libraries =
      collada_triangle() +
      "<library_cameras><camera "
      "id=\"eye\"><optics><technique_common><perspective><xfov>50</xfov></perspective>"
      "</technique_common></optics></camera></library_cameras>";
  const LoadedScene loaded = load_collada(
      collada_text(libraries, collada_shape_node() +
                                  "<node><translate>0 0 1</translate><instance_camera url=\"#eye\"/></node>"),
      cs184);
  CHECK(loaded.scene.camera.forward == Vec3{0, 0, -1});
  CHECK(messages(loaded) ==
        std::vector<std::string>{"CS184's program looks from the side of the point one unit in front of the "
                                 "camera, and that is the origin; the scene is seen from +z"});
}

TEST_CASE("by CS184's rules polygons that its program does not read stay whole") {
  const auto triangle_count = [](const std::string& name, const std::string& vcount) {
    const std::string list = "<" + name + " count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\" " +
                             "offset=\"0\"/>" + vcount + "<p>0 1 2 3</p></" + name + ">";
    return load_collada(collada_text(collada_mesh(4, "0 0 0 1 0 0 1 1 0 0 1 0", list), collada_shape_node()),
                        cs184)
        .scene.geometry->triangle_count();
  };
  CHECK(triangle_count("polygons", "") == 2);
  CHECK(triangle_count("polylist", "<vcount>4</vcount>") == 1);
}

TEST_CASE("by CS184's rules the last model of a material counts, and the others are named") {
  const std::string libraries =
      collada_triangle() +
      "<library_effects><effect id=\"paint\"><extra><technique profile=\"CGL\"><mirror><reflectance>1 0 0"
      "</reflectance></mirror><emission><radiance>0 2 0</radiance></emission></technique></extra></effect>"
      "</library_effects><library_materials><material id=\"red\"><instance_effect url=\"#paint\"/>"
      "</material></library_materials>";
  const std::string node =
      "<node><instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material "
      "symbol=\"a\" target=\"#red\"/></technique_common></bind_material></instance_geometry></node>";
  const LoadedScene loaded = load_collada(collada_text(libraries, node), cs184);
  CHECK(loaded.scene.lights.size() == 1);
  CHECK(messages(loaded) ==
        std::vector<std::string>{
            "this surface is <emission>; a surface has one model, and <mirror> is left out"});
  const LoadedScene standard = load_collada(collada_text(libraries, node));
  CHECK(standard.scene.lights.empty());
  CHECK(std::holds_alternative<Mirror>(standard.scene.materials.at(0).model));
}

TEST_CASE("CS184's extensions are read by the name of their ancestor, too") {
  const auto load = [](const std::string& profile) {
    const std::string open = "<extra><technique profile=\"" + profile + "\">", close = "</technique></extra>";
    const std::string libraries =
        light("<point><color>1 1 1</color></point>", open + "<area><color>1 2 3</color></area>" + close) +
        "<library_geometries><geometry id=\"shape\">" + open + "<sphere><radius>0.5</radius></sphere>" +
        close + "</geometry></library_geometries><library_effects><effect id=\"glow\">" + open +
        "<emission><radiance>4 5 6</radiance></emission>" + close +
        "</effect></library_effects><library_materials><material id=\"glow-material\"><instance_effect "
        "url=\"#glow\"/></material></library_materials>";
    const std::string ball =
        "<node><instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material "
        "symbol=\"a\" target=\"#glow-material\"/></technique_common></bind_material></instance_geometry>"
        "</node>";
    return load_collada(collada_text(libraries, ball + instance("<translate>0 0 3</translate>")), cs184);
  };
  for (const char* profile : {"CGL", "CMU462"}) {
    CAPTURE(profile);
    const LoadedScene loaded = load(profile);
    CHECK(loaded.scene.geometry->sphere_count() == 1);
    CHECK(loaded.scene.geometry->triangle_count() == 2);  // the area light's
    CHECK(loaded.scene.lights.size() == 2);
    CHECK(messages(loaded).empty());
  }
}

TEST_CASE("by CS184's rules the asset of a part of the file does not count") {
  std::string libraries = collada_triangle();
  libraries.insert(libraries.find("<mesh>"), "<asset><unit meter=\"100\"/><up_axis>Z_UP</up_axis></asset>");
  const auto upper = [&](const LoadOptions& options) {
    return load_collada(collada_text(libraries, collada_shape_node()), options)
        .scene.geometry->bounds()
        .upper;
  };
  CHECK(upper({}) == Vec3{100, 0, 0});
  CHECK(upper(cs184) == Vec3{1, 1, 0});
}

}  // namespace twinray
