// SPDX-License-Identifier: Apache-2.0
// What of a scene is seen, and by which camera: several cameras, hidden nodes, layers, and the
// spaces of nested assets.
#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/near.h"

namespace twinray {
namespace {

constexpr float scene_tolerance = 1e-5f;
const std::string shape_node = "<node id=\"n\"><instance_geometry url=\"#shape\"/></node>";

std::string camera(const std::string& id, const std::string& lens) {
  return "<camera id=\"" + id + "\" name=\"" + id + " name\"><optics><technique_common>" + lens +
         "</technique_common></optics></camera>";
}

std::string camera_node(const std::string& id, const std::string& x) {
  return "<node id=\"" + id + "-node\"><translate>" + x + " 0 0</translate><instance_camera url=\"#" + id +
         "\"/></node>";
}

/// Two cameras, at x = 1 and x = 2.
std::string two_cameras(const std::string& further = "") {
  const std::string lens = "<perspective><xfov>40</xfov></perspective>";
  return collada_text("<library_cameras>" + camera("one", lens) + camera("two", lens) + "</library_cameras>" +
                          collada_triangle(),
                      shape_node + camera_node("one", "1") + camera_node("two", "2") + further);
}

void check_close(const Vec3& a, const Vec3& b) { test::check_near(a, b, 1e-5f); }

Vec3 second_vertex(const LoadedScene& loaded) { return mesh_of(loaded).positions[1]; }

}  // namespace

TEST_CASE("of several cameras the first one sees, and the others are known by name") {
  const LoadedScene loaded = load_collada(two_cameras());
  CHECK(loaded.scene.camera.position == Vec3{1, 0, 0});
  CHECK(loaded.summary.camera == "one name");
  CHECK(loaded.summary.cameras == std::vector<std::string>{"one name", "two name"});
  CHECK(loaded.warnings.empty());
}

TEST_CASE("a camera is chosen by its name or id, or that of its node") {
  for (const std::string name : {"two", "two name", "two-node"}) {
    LoadOptions options;
    options.camera_name = name;
    const LoadedScene loaded = load_collada(two_cameras(), options);
    CHECK(loaded.scene.camera.position == Vec3{2, 0, 0});
    CHECK(loaded.summary.camera == "two name");
  }
  LoadOptions options;
  options.camera_name = "three";
  CHECK(collada_error(two_cameras(), options) ==
        "scene.dae: no camera, and no node of one, has the name \"three\"; the scene has \"one name\", \"two "
        "name\"");
  CHECK(collada_error(collada_text(collada_triangle(), shape_node), options) ==
        "scene.dae: no camera, and no node of one, has the name \"three\"; the scene has no camera");
}

TEST_CASE("a scene's render may say which camera sees") {
  const auto evaluate = [](const std::string& attributes) {
    return "<evaluate_scene" + attributes + "><render camera_node=\"#two-node\"/></evaluate_scene>";
  };
  CHECK(load_collada(two_cameras(evaluate(""))).scene.camera.position == Vec3{2, 0, 0});
  CHECK(load_collada(two_cameras(evaluate(" enable=\"false\""))).scene.camera.position == Vec3{1, 0, 0});
}

TEST_CASE("a camera that does not make the picture may be wrong") {
  const std::string text =
      collada_text("<library_cameras>" + camera("good", "<perspective><xfov>40</xfov></perspective>") +
                       camera("bad", "<perspective/>") + "</library_cameras>" + collada_triangle(),
                   shape_node + camera_node("good", "1") + camera_node("bad", "2"));
  CHECK(load_collada(text).scene.camera.position == Vec3{1, 0, 0});
}

TEST_CASE("an orthographic camera's frame is in scene units, scaled with its node") {
  const auto lens = [](const std::string& elements, const std::string& scale = "") {
    return load_collada(
               collada_text("<library_cameras>" +
                                camera("eye", "<orthographic>" + elements + "</orthographic>") +
                                "</library_cameras>" + collada_triangle(),
                            shape_node + "<node>" + scale + "<instance_camera url=\"#eye\"/></node>"))
        .scene.camera;
  };
  const Camera both = lens("<xmag>2</xmag><ymag>3</ymag><znear>0.1</znear><zfar>10</zfar>");
  CHECK(both.projection == Projection::orthographic);
  CHECK(both.tan_half_width == 2);
  CHECK(both.tan_half_height == 3);
  CHECK(lens("<xmag>2</xmag><aspect_ratio>4</aspect_ratio>").tan_half_height == 0.5f);
  CHECK(fit_frame(lens("<ymag>2</ymag><aspect_ratio>4</aspect_ratio>"), 100, 100).tan_half_width == 2);
  CHECK(fit_frame(lens("<xmag>2</xmag>"), 400, 100).tan_half_height == 0.5f);
  CHECK(lens("<xmag>2</xmag><ymag>3</ymag>", "<scale>10 1 1</scale>").tan_half_width == Approx(20));
}

TEST_CASE("what an exporter hides is left out, with all below, but for cameras") {
  for (const std::string profile : {"FCOLLADA", "MAYA"}) {
    const std::string hide =
        "<extra><technique profile=\"" + profile + "\"><visibility>0</visibility></technique></extra>";
    const LoadedScene loaded = load_collada(collada_text(
        "<library_cameras>" + camera("eye", "<perspective><xfov>40</xfov></perspective>") +
            "</library_cameras>" + collada_triangle(),
        shape_node + "<node name=\"top\">" + camera_node("eye", "7") +
            "<node name=\"below\"><instance_geometry url=\"#shape\"/></node>" + hide + "</node>"));
    CHECK(loaded.scene.geometry->triangle_count() == 1);
    CHECK(loaded.scene.camera.position == Vec3{7, 0, 0});
    REQUIRE(loaded.summary.notes.size() == 1);
    CHECK(loaded.summary.notes[0] == "hidden by the file, and left out: \"below\"");
  }
}

TEST_CASE("layers that the scene's render names are shown, and others not") {
  const auto triangles = [](const std::string& renders) {
    const auto node = [](const std::string& layer) {
      return "<node" + layer + "><instance_geometry url=\"#shape\"/></node>";
    };
    return load_collada(collada_text(collada_triangle(),
                                     node(" layer=\"near glow\"") + node(" layer=\"far\"") + node("") +
                                         "<evaluate_scene>" + renders + "</evaluate_scene>"))
        .scene.geometry->triangle_count();
  };
  CHECK(triangles("") == 3);
  CHECK(triangles("<render/>") == 3);
  CHECK(triangles("<render><layer>glow</layer></render>") == 1);
  CHECK(triangles("<render><layer>near</layer><layer>far</layer></render>") == 2);
  CHECK(triangles("<render><layer>near</layer></render><render><layer>far</layer></render>") == 2);
}

TEST_CASE("nested assets have their own unit and axis") {
  const auto load = [](const std::string& node_asset, const std::string& geometry_asset) {
    std::string geometry = collada_triangle();
    geometry.insert(geometry.find("<mesh>"), geometry_asset);
    return load_collada(collada_text(geometry, "<node>" + node_asset +
                                                   "<translate>0 0 1</translate>"
                                                   "<instance_geometry url=\"#shape\"/></node>"));
  };
  const std::string inches = "<asset><unit name=\"inch\" meter=\"0.0254\"/></asset>",
                    upward = "<asset><up_axis>Z_UP</up_axis></asset>";
  check_close(second_vertex(load("", "")), {1, 0, 1});
  check_close(second_vertex(load("", inches)), {0.0254f, 0, 1});
  check_close(second_vertex(load(inches, "")), {0.0254f, 0, 0.0254f});
  check_close(second_vertex(load(inches, inches)), {0.0254f, 0, 0.0254f});
  check_close(second_vertex(load(upward, upward)), {1, 1, 0});
  check_close(second_vertex(load("", upward)), {1, 0, 1});
  check_close(mesh_of(load("", upward)).positions[2], {0, 0, 0});
  check_close(mesh_of(load(upward, "")).positions[2], {0, 1, -1});
}

TEST_CASE("a node of a library is in the space that it is placed in, unless an asset says another one") {
  const auto load = [](const std::string& asset) {
    return load_collada(collada_text(collada_triangle() + "<library_nodes>" + asset +
                                         "<node id=\"n\"><node><translate>0 0 3</translate>"
                                         "<instance_geometry url=\"#shape\"/></node></node></library_nodes>",
                                     "<node><asset><unit meter=\"10\"/></asset><instance_node "
                                     "url=\"#n\"/></node>"));
  };
  check_close(second_vertex(load("")), {10, 0, 30});
  check_close(second_vertex(load("<asset><unit meter=\"2\"/></asset>")), {2, 0, 6});
}

TEST_CASE("a camera's asset is that of its lengths, and its up axis is its up") {
  const auto load = [](const std::string& asset, const std::string& lens) {
    const std::string node = "<node><translate>0 0 5</translate><instance_camera url=\"#one\"/></node>";
    LoadOptions options;
    options.clip_as_file = true;
    std::string element = camera("one", lens);
    element.insert(element.find("<optics>"), asset);
    return load_collada(
               collada_text("<library_cameras>" + element + "</library_cameras>" + collada_triangle(),
                            shape_node + node),
               options)
        .scene.camera;
  };
  const std::string inches = "<asset><unit meter=\"0.0254\"/></asset>",
                    lens = "<orthographic><xmag>100</xmag><znear>200</znear><zfar>300</zfar></orthographic>";
  CHECK(load("", lens).tan_half_width == 100.0f);
  CHECK(std::fabs(load(inches, lens).tan_half_width - 2.54f) <= scene_tolerance);
  CHECK(std::fabs(load(inches, lens).clip_near - 5.08f) <= scene_tolerance);
  const Camera upward = load("<asset><up_axis>Z_UP</up_axis></asset>", lens);
  check_close(upward.up, {0, 0, 1});
  check_close(upward.forward, {0, 1, 0});
  check_close(upward.position, {0, 0, 5});
}

TEST_CASE("a bind_vertex_input is known, and changes nothing while textures are not rendered") {
  const LoadedScene loaded = load_collada(collada_text(
      collada_triangle() +
          "<library_effects><effect "
          "id=\"fx\"><profile_COMMON><technique><lambert/></technique></profile_COMMON>"
          "</effect></library_effects><library_materials><material id=\"m\"><instance_effect url=\"#fx\"/>"
          "</material></library_materials>",
      "<node><instance_geometry url=\"#shape\"><bind_material><technique_common><instance_material "
      "symbol=\"s\" target=\"#m\"><bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" "
      "input_set=\"0\"/></instance_material></technique_common></bind_material></instance_geometry></node>"));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(loaded.warnings.empty());
}

TEST_CASE("a nested asset without unit and axis changes nothing") {
  const LoadedScene loaded = load_collada(collada_text(
      collada_triangle(),
      "<node><asset><created/><modified/></asset><instance_geometry url=\"#shape\"/></node>", "Z_UP"));
  check_close(second_vertex(loaded), {-1, 0, 0});
  CHECK(loaded.warnings.empty());
}

TEST_CASE("without unit and axis a file is in meters, with Y up") {
  std::string text = collada_text(collada_triangle(), shape_node);
  text.replace(text.find("<asset>"), text.find("</asset>") - text.find("<asset>") + 8, "<asset/>");
  const LoadedScene loaded = load_collada(text);
  CHECK(loaded.summary.unit_meters == 1);
  CHECK(loaded.summary.up_axis == 'Y');
  check_close(second_vertex(loaded), {1, 0, 0});
}

}  // namespace twinray
