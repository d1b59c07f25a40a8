// SPDX-License-Identifier: Apache-2.0
#include "io/collada_mesh.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

constexpr float tolerance = 1e-6f;

const std::string square = "0 0 0 1 0 0 1 1 0 0 1 0";
const std::string vertex_input = "<input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>";

LoadedScene load_shape(const std::string& library, const std::string& transform = "") {
  return load_collada(
      collada_text(library, "<node>" + transform + "<instance_geometry url=\"#shape\"/></node>"));
}

/// The triangles of one primitive element over the unit square.
std::vector<Triangle> triangles_of(const std::string& element) {
  return mesh_of(load_shape(collada_mesh(4, square, element))).triangles;
}

Vec3 front_of(const Mesh& mesh, std::size_t i = 0) {
  const auto [a, b, c] = mesh.triangles[i];
  return normalize(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
}

}  // namespace

TEST_CASE("triangles, polylists, polygons, strips and fans give the same square") {
  const std::vector<Triangle> two{{0, 1, 2}, {0, 2, 3}};
  CHECK(triangles_of("<triangles count=\"2\">" + vertex_input + "<p>0 1 2 0 2 3</p></triangles>") == two);
  CHECK(triangles_of("<polylist count=\"1\">" + vertex_input +
                     "<vcount>4</vcount><p>0 1 2 3</p></polylist>") == two);
  CHECK(triangles_of("<polygons count=\"2\">" + vertex_input + "<p>0 1 2</p><p>0 2 3</p></polygons>") == two);
  CHECK(triangles_of("<trifans count=\"1\">" + vertex_input + "<p>0 1 2 3</p></trifans>") == two);
  const std::vector<Triangle> strip{{0, 1, 3}, {1, 2, 3}};
  CHECK(triangles_of("<tristrips count=\"1\">" + vertex_input + "<p>0 1 3 2</p></tristrips>") == strip);
}

TEST_CASE("a polygon that is not convex is cut along its ears") {
  // A chevron: the fan around its first corner would cover what lies outside.
  const LoadedScene loaded = load_shape(
      collada_mesh(4, "0 2 0 -1 0 0 0 1 0 1 0 0",
                   "<polylist count=\"1\">" + vertex_input + "<vcount>4</vcount><p>1 2 3 0</p></polylist>"));
  const Mesh& mesh = mesh_of(loaded);
  REQUIRE(mesh.triangles.size() == 2);
  float area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z / 2;
  CHECK(area == Approx(1));
  CHECK(front_of(mesh, 0).z > 0);
  CHECK(front_of(mesh, 1).z > 0);
}

TEST_CASE("inputs are told apart by their offsets, and may share one") {
  const std::string element =
      "<triangles count=\"1\"><input semantic=\"NORMAL\" source=\"#n\" offset=\"2\"/>"
      "<input semantic=\"VERTEX\" source=\"#vertices\" offset=\"1\"/>"
      "<input semantic=\"COLOR\" source=\"#n\" offset=\"0\"/><p>9 0 1  9 1 0  9 3 1</p></triangles>";
  const LoadedScene loaded =
      load_shape(collada_mesh(4, square, collada_source("n", 2, "0 0 -3 0 0 2") + element));
  const Mesh& mesh = mesh_of(loaded);
  CHECK(loaded.warnings.empty());
  CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}});
  CHECK(mesh.normal_indices == std::vector<Triangle>{{1, 0, 1}});
  CHECK(mesh.normals == std::vector<Vec3>{{0, 0, -1}, {0, 0, 1}});
}

TEST_CASE("normals may belong to the vertices") {
  const std::string library =
      "<library_geometries><geometry id=\"shape\"><mesh>" + collada_source("p", 3, "0 0 0 1 0 0 0 1 0") +
      collada_source("n", 3, "0 0 1 0 1 1 1 0 1") +
      "<vertices id=\"vertices\"><input semantic=\"POSITION\" source=\"#p\"/><input semantic=\"NORMAL\" "
      "source=\"#n\"/>"
      "</vertices><triangles count=\"1\">" +
      vertex_input + "<p>0 1 2</p></triangles></mesh></geometry></library_geometries>";
  const LoadedScene loaded = load_shape(library);
  CHECK(mesh_of(loaded).normal_indices == mesh_of(loaded).triangles);
  CHECK(length(mesh_of(loaded).normals[1]) == Approx(1));
}

TEST_CASE("an accessor picks by stride, offset and named parameters") {
  const std::string library =
      "<library_geometries><geometry id=\"shape\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"16\">"
      "99  0 7 0 0 99  1 7 0 0 99  0 7 1 0 99</float_array><technique_common>"
      "<accessor source=\"#a\" count=\"3\" offset=\"1\" stride=\"5\"><param name=\"X\"/><param "
      "type=\"float\"/>"
      "<param name=\"Y\"/><param name=\"Z\"/></accessor></technique_common></source>"
      "<vertices id=\"vertices\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles "
      "count=\"1\">" +
      vertex_input + "<p>0 1 2</p></triangles></mesh></geometry></library_geometries>";
  CHECK(mesh_of(load_shape(library)).positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("texture coordinates come with the triangles") {
  const std::string uv =
      "<source id=\"uv\"><float_array id=\"uva\" count=\"4\">0 0.5 1 0.25</float_array><technique_common>"
      "<accessor source=\"#uva\" count=\"2\" stride=\"2\"><param name=\"S\"/><param name=\"T\"/></accessor>"
      "</technique_common></source>";
  const LoadedScene loaded =
      load_shape(collada_mesh(4, square,
                              uv + "<triangles count=\"1\">" + vertex_input +
                                  "<input semantic=\"TEXCOORD\" source=\"#uv\" offset=\"1\" set=\"0\"/><p>0 "
                                  "1 1 0 2 1</p></triangles>"));
  CHECK(mesh_of(loaded).uvs == std::vector<Vec2>{{0, 0.5f}, {1, 0.25f}});
  CHECK(mesh_of(loaded).uv_indices == std::vector<Triangle>{{1, 0, 1}});
}

TEST_CASE("a mirror keeps the front the front, and normals on its side") {
  const std::string element =
      "<triangles count=\"1\">" + vertex_input +
      "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>";
  const std::string library = collada_mesh(3, "0 0 0 1 0 0 0 1 0", collada_source("n", 1, "0 0 1") + element);
  const Mesh plain = mesh_of(load_shape(library)),
             flipped_x = mesh_of(load_shape(library, "<scale>-1 1 1</scale>")),
             flipped_z = mesh_of(load_shape(library, "<scale>1 1 -1</scale>"));
  CHECK(front_of(plain) == Vec3{0, 0, 1});
  CHECK(front_of(flipped_x) == Vec3{0, 0, 1});
  CHECK(flipped_x.normals[0] == Vec3{0, 0, 1});
  CHECK(front_of(flipped_z) == Vec3{0, 0, -1});
  CHECK(flipped_z.normals[0] == Vec3{0, 0, -1});
}

TEST_CASE("normals stay perpendicular under an uneven scale") {
  const std::string element =
      "<triangles count=\"1\">" + vertex_input +
      "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>";
  const std::string library = collada_mesh(3, "1 0 0 0 1 0 0 0 1", collada_source("n", 1, "1 1 1") + element);
  const Mesh mesh = mesh_of(load_shape(library, "<scale>1e-9 5e-9 2e-9</scale>"));
  CHECK(max_abs(mesh.normals[0] - front_of(mesh)) < tolerance);
}

TEST_CASE("degenerate triangles are dropped and counted, with the vertices only they use") {
  const LoadedScene loaded = load_shape(collada_mesh(
      4, square, "<triangles count=\"3\">" + vertex_input + "<p>0 0 1 0 1 2 3 3 3</p></triangles>"));
  CHECK(loaded.summary.dropped_triangles == 2);
  CHECK(mesh_of(loaded).positions.size() == 3);
  CHECK(loaded.scene.geometry->triangle_count() == 1);
}

TEST_CASE("each primitive element becomes a mesh with its own material") {
  const auto element = [](const std::string& symbol, const std::string& p) {
    return "<triangles count=\"1\" material=\"" + symbol + "\">" + vertex_input + "<p>" + p +
           "</p></triangles>";
  };
  const auto material = [](const std::string& name, const std::string& color) {
    return "<material id=\"" + name + "\"><instance_effect url=\"#" + name + "-fx\"/></material>" +
           "</library_materials><library_effects><effect id=\"" + name +
           "-fx\"><profile_COMMON><technique><lambert><diffuse><color>" + color +
           "</color></diffuse></lambert></technique></profile_COMMON></effect></"
           "library_effects><library_materials>";
  };
  const std::string libraries = collada_mesh(4, square, element("a", "0 1 2") + element("b", "0 2 3")) +
                                "<library_materials>" + material("red", "1 0 0") +
                                material("green", "0 1 0 1") + "</library_materials>";
  const LoadedScene loaded = load_collada(collada_text(
      libraries,
      "<node name=\"leaf\"><instance_geometry url=\"#shape\"><bind_material><technique_common>"
      "<instance_material symbol=\"b\" target=\"#green\"/><instance_material symbol=\"a\" target=\"#red\"/>"
      "</technique_common></bind_material></instance_geometry></node>"));
  REQUIRE(loaded.scene.bindings.size() == 2);
  const auto reflectance = [&](std::size_t shape) {
    return std::get<Lambert>(loaded.scene.materials[loaded.scene.bindings[shape].material].model).reflectance;
  };
  CHECK(reflectance(0) == Rgb{1, 0, 0});
  CHECK(reflectance(1) == Rgb{0, 1, 0});
  CHECK(mesh_of(loaded, 0).name == "leaf/a");
  CHECK(mesh_of(loaded, 1).name == "leaf/b");
}

TEST_CASE("a CGL sphere stands at its node's origin, scaled with it") {
  for (const std::string profile : {"CGL", "CMU462"}) {
    const LoadedScene loaded = load_shape(
        "<library_geometries><geometry id=\"shape\"><extra><technique profile=\"" + profile +
            "\"><sphere><radius>.25</radius></sphere></technique></extra></geometry></library_geometries>",
        "<translate>1 2 3</translate><rotate>1 2 3 40</rotate><scale>4 4 4</scale>");
    REQUIRE(loaded.scene.geometry->sphere_count() == 1);
    const Sphere& sphere = loaded.scene.geometry->sphere_set(0)->spheres[0];
    CHECK(sphere.center == Vec3{1, 2, 3});
    CHECK(sphere.radius == Approx(1));
    CHECK(loaded.warnings.empty());
  }
}

TEST_CASE("without a material a surface is grey") {
  const LoadedScene loaded = load_shape(collada_triangle());
  CHECK(std::get<Lambert>(loaded.scene.materials[loaded.scene.bindings[0].material].model).reflectance ==
        Rgb{0.5f, 0.5f, 0.5f});
}

}  // namespace twinray
