// SPDX-License-Identifier: Apache-2.0
#include "io/collada/mesh.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"

namespace twinray {
namespace {

constexpr float area_tolerance = 1e-6f;

const std::string square = "0 0 0 1 0 0 1 1 0 0 1 0";
const std::string vertex_input = "<input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>";

LoadedScene load_shape(const std::string& library, const std::string& transform = "") {
  return load_collada(collada_text(library, collada_shape_node(transform)));
}

/// The triangles of one primitive element over the unit square.
std::vector<Triangle> triangles_of(const std::string& element) {
  return mesh_of(load_shape(collada_mesh(4, square, element))).triangles;
}

Vec3 front_of(const Mesh& mesh, std::size_t i = 0) {
  const auto [a, b, c] = mesh.triangles[i];
  return normalize(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
}

/// The area of all triangles of a mesh in the plane x, y.
float flat_area(const Mesh& mesh) {
  float area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z / 2;
  return area;
}

/// A geometry whose positions are in this source.
std::string mesh_with_source(const std::string& source) {
  return "<library_geometries><geometry id=\"shape\"><mesh>" + source +
         "<vertices id=\"vertices\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles "
         "count=\"1\">" +
         vertex_input + "<p>0 1 2</p></triangles></mesh></geometry></library_geometries>";
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

TEST_CASE("primitive elements share their sources, which are read once") {
  const std::string triangles = "<triangles count=\"1\">" + vertex_input + "<p>0 1 2</p></triangles>";
  std::string mesh = collada_mesh(4, square, triangles + triangles + triangles);
  mesh.replace(mesh.find("count=\"12\""), 10, "count=\"13\"");  // a warning each time that it is read
  const LoadedScene loaded = load_shape(mesh);
  CHECK(loaded.scene.geometry->shapes().size() == 3);
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "count says 13, and the array has 12 numbers; all of them are read");
  CHECK(loaded.warnings[0].count == 1);
}

TEST_CASE("a primitive element takes what it uses of its sources, and no more") {
  std::string positions;
  for (int i = 0; i < 1000; ++i) positions += std::to_string(i) + " " + std::to_string(i * i) + " 0 ";
  for (const char* corners : {"5 7 900", "900 5 7"}) {
    const LoadedScene loaded = load_shape(collada_mesh(
        1000, positions, "<triangles count=\"1\">" + vertex_input + "<p>" + corners + "</p></triangles>"));
    const Mesh& mesh = mesh_of(loaded);
    CHECK(mesh.positions == std::vector<Vec3>{{5, 25, 0}, {7, 49, 0}, {900, 810000, 0}});
    CHECK(mesh.positions[mesh.triangles[0][0]].x == float(std::stoi(corners)));
  }
}

TEST_CASE("numbers that are not finite matter where they are used") {
  const std::string triangle = "<triangles count=\"1\">" + vertex_input + "<p>0 1 2</p></triangles>";
  for (const char* number :
       {"nan", "NaN", "-nan(ind)", "inf", "-INF", "Infinity", "1.#QNAN", "-1.#IND", "1.#INF00"}) {
    CAPTURE(number);
    const std::string unused = "0 0 0 1 0 0 1 1 0 0 " + std::string(number) + " 0";
    const LoadedScene loaded = load_shape(collada_mesh(4, unused, triangle));
    CHECK(loaded.warnings.empty());
    CHECK(mesh_of(loaded).positions.size() == 3);
    const std::string used = "0 0 0 1 0 0 1 " + std::string(number) + " 0 0 1 0";
    CHECK_THROWS_AS(load_shape(collada_mesh(4, used, triangle)), Error);
  }
  for (const char* text : {"nothing", "inch", "1.#", "nix", "0x10"})
    CHECK_THROWS_AS(load_shape(collada_mesh(4, "0 0 0 1 0 0 1 1 0 0 " + std::string(text) + " 0", triangle)),
                    Error);
}

TEST_CASE("texture coordinates that are not there are left out with a warning, as nothing shows them") {
  const std::string uvs =
      "<source id=\"uvs\"><float_array id=\"uv-array\" count=\"4\">0 0 nan 1</float_array><technique_common>"
      "<accessor source=\"#uv-array\" count=\"2\" stride=\"2\"><param name=\"S\"/><param "
      "name=\"T\"/></accessor>"
      "</technique_common></source>";
  for (const char* indices : {"0 0 1 0 2 0", "0 0 1 0 2 1", "0 0 1 0 2 2"}) {
    const LoadedScene loaded = load_shape(collada_mesh(
        4, square,
        uvs + "<triangles count=\"1\">" + vertex_input +
            "<input semantic=\"TEXCOORD\" source=\"#uvs\" offset=\"1\"/><p>" + indices + "</p></triangles>"));
    const bool is_right = std::string(indices).back() == '0';
    CHECK(mesh_of(loaded).triangles.size() == 1);
    CHECK(mesh_of(loaded).uvs.size() == (is_right ? 1 : 0));
    CHECK(loaded.warnings.size() == (is_right ? 0 : 1));
  }
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
      "<input semantic=\"TANGENT\" source=\"#n\" offset=\"0\"/><p>9 0 1  9 1 0  9 3 1</p></triangles>";
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
  CHECK(max_abs(mesh.normals[0] - front_of(mesh)) < area_tolerance);
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

TEST_CASE("a polygon's holes are cut out") {
  const std::string frame = "0 0 0 4 0 0 4 4 0 0 4 0  1 1 0 2 1 0 2 2 0 1 2 0  3 3 0 3.5 3 0 3 3.5 0";
  const LoadedScene loaded = load_shape(collada_mesh(
      11, frame,
      "<polygons count=\"3\">" + vertex_input +
          "<ph><p>0 1 2 3</p><h>4 5 6 7</h><h>8 9 10</h></ph><p>4 5 6 7</p><ph><p>8 9 10</p></ph>"
          "</polygons>"));
  CHECK(messages(loaded).empty());
  CHECK(flat_area(mesh_of(loaded)) == Approx(16));
  const LoadedScene with_hole =
      load_shape(collada_mesh(11, frame,
                              "<polygons count=\"1\">" + vertex_input +
                                  "<ph><p>0 1 2 3</p><h>4 5 6 7</h><h>8 9</h></ph></polygons>"));
  CHECK(flat_area(mesh_of(with_hole)) == Approx(15));
  CHECK(messages(with_hole) == std::vector<std::string>{"a hole has fewer than 3 corners, and is left out"});
}

TEST_CASE("a convex mesh is read as a mesh") {
  std::string library = collada_triangle();
  library.replace(library.find("<mesh>"), 6, "<convex_mesh>");
  library.replace(library.find("</mesh>"), 7, "</convex_mesh>");
  const LoadedScene loaded = load_shape(library);
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(messages(loaded).empty());
}

TEST_CASE("vertex colors are told") {
  const LoadedScene loaded = load_shape(collada_mesh(
      4, square,
      "<triangles count=\"1\">" + vertex_input +
          "<input semantic=\"COLOR\" source=\"#positions\" offset=\"0\"/><p>0 1 2</p></triangles>"));
  CHECK(messages(loaded) ==
        std::vector<std::string>{"vertex colors are not rendered; the surface has its material's color"});
}

TEST_CASE("counts that lie are told, and the data is right") {
  const std::string numbers = "0 0 0 1 0 0 0 1 0";
  const auto source = [&](const std::string& array, const std::string& accessor) {
    return mesh_with_source(
        "<source id=\"p\"><float_array id=\"a\"" + array + ">" + numbers +
        "</float_array><technique_common><accessor source=\"#a\"" + accessor +
        "><param name=\"X\"/><param name=\"Y\"/><param name=\"Z\"/></accessor></technique_common>"
        "</source>");
  };
  const auto message = [&](const std::string& array, const std::string& accessor) {
    const LoadedScene loaded = load_shape(source(array, accessor));
    CHECK(loaded.scene.geometry->triangle_count() == 1);
    const auto all = messages(loaded);
    REQUIRE(all.size() == 1);
    return all[0];
  };
  const std::string good = " count=\"9\"", stride = " stride=\"3\"";
  CHECK(message(" count=\"8\"", " count=\"3\"" + stride) ==
        "count says 8, and the array has 9 numbers; all of them are read");
  CHECK(message("", " count=\"3\"" + stride) ==
        "this <float_array> has no count, which it needs; all its numbers are read");
  CHECK(message(good, " count=\"4000000000\"" + stride) ==
        "count says 4000000000, and the array holds 3 elements of stride 3 from offset 0; these are read");
  CHECK(message(good, " count=\"2\"" + stride) ==
        "an index beyond the 2 elements that <source id=\"p\"> counts; its array has 3, and these are used");
  CHECK(message(good, " count=\"3\"") ==
        "this <accessor> has no stride, which would be 1; it has 3 parameters, and that is taken to be its "
        "stride");
  const auto element_message = [&](const std::string& count) {
    return messages(load_shape(
        collada_mesh(3, numbers, "<triangles" + count + ">" + vertex_input + "<p>0 1 2</p></triangles>")));
  };
  CHECK(element_message(" count=\"7\"") ==
        std::vector<std::string>{"count says 7, and <triangles> has 1; all of it is read"});
  CHECK(element_message("") ==
        std::vector<std::string>{"this <triangles> has no count, which it needs; all of it is read"});
}

TEST_CASE("a source's only array needs no id, and a source no accessor") {
  const std::string numbers = ">0 0 0 1 0 0 0 1 0</float_array>";
  const auto message = [](const std::string& source) {
    const LoadedScene loaded = load_shape(mesh_with_source("<source id=\"p\">" + source + "</source>"));
    CHECK(loaded.scene.geometry->triangle_count() == 1);
    REQUIRE(loaded.warnings.size() == 1);
    return loaded.warnings[0].message;
  };
  CHECK(message("<float_array count=\"9\"" + numbers +
                "<technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"/></technique_common>") ==
        "no <float_array> is \"#a\"; this <accessor> is taken to mean the only one of its <source>");
  CHECK(message("<float_array count=\"9\"" + numbers) ==
        "this <source> has no <accessor>; its array is read as elements of 3 numbers");
}

TEST_CASE("an array of whole numbers is as good, and parameters without any name count") {
  const LoadedScene loaded = load_shape(mesh_with_source(
      "<source id=\"p\"><int_array id=\"a\" count=\"9\">0 0 0 1 0 0 0 1 0</int_array>"
      "<technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"><param/><param/><param/>"
      "</accessor></technique_common></source>"));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(messages(loaded).empty());
}

TEST_CASE("an only input needs no offset") {
  const LoadedScene loaded = load_shape(collada_mesh(
      3, "0 0 0 1 0 0 0 1 0",
      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#vertices\"/><p>0 1 2</p></triangles>"));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(messages(loaded) ==
        std::vector<std::string>{
            "this <input> has no offset, which it needs; as the only one it is taken to have 0"});
}

TEST_CASE("a symbol that is not bound means the material with that id, where there is one") {
  const std::string materials =
      "<library_effects><effect id=\"fx\"><profile_COMMON><technique><lambert><diffuse><color>1 0 0 "
      "1</color></diffuse>"
      "</lambert></technique></profile_COMMON></effect></library_effects><library_materials><material "
      "id=\"red\">"
      "<instance_effect url=\"#fx\"/></material></library_materials>";
  const LoadedScene loaded =
      load_shape(materials + collada_mesh(3, "0 0 0 1 0 0 0 1 0",
                                          "<triangles count=\"1\" material=\"red\">" + vertex_input +
                                              "<p>0 1 2</p></triangles>"));
  CHECK(std::get<Lambert>(loaded.scene.materials[0].model).reflectance == Rgb{1, 0, 0});
  CHECK(messages(loaded) ==
        std::vector<std::string>{"no <instance_material> binds the symbol \"red\"; it is taken to "
                                 "mean the <material> with that id"});
}

TEST_CASE("texture coordinates and normals whose indices lead beyond their data are left out") {
  const std::string element =
      "<polygons count=\"2\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>"
      "<input semantic=\"NORMAL\" source=\"#positions\" offset=\"1\"/>"
      "<input semantic=\"TEXCOORD\" source=\"#positions\" offset=\"2\"/>"
      "<p>0 0 0 1 1 1 2 2 2</p><p>0 0 0 2 9 2 3 3 9</p></polygons>";
  const LoadedScene loaded = load_shape(collada_mesh(4, square, element));
  const Mesh& mesh = mesh_of(loaded);
  CHECK(mesh.triangles.size() == 2);
  CHECK((mesh.normals.empty() && mesh.normal_indices.empty()));
  CHECK((mesh.uvs.empty() && mesh.uv_indices.empty()));
  const std::string range =
      "the index 9 is out of range: <source id=\"positions\"> has 4 elements, numbered from 0; ";
  CHECK(messages(loaded) ==
        std::vector<std::string>{range + "the normals of this <polygons> are left out",
                                 range + "the texture coordinates of this <polygons> are left out"});
}

TEST_CASE("positions of two numbers lie in the plane z = 0") {
  const LoadedScene loaded = load_shape(mesh_with_source(
      "<source id=\"p\"><float_array id=\"a\" count=\"6\">0 0 1 0 0 1</float_array><technique_common>"
      "<accessor source=\"#a\" count=\"3\" stride=\"2\"><param name=\"X\"/><param name=\"Y\"/>"
      "</accessor></technique_common></source>"));
  CHECK(mesh_of(loaded).positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(messages(loaded) ==
        std::vector<std::string>{"this <accessor> has two parameters, and three are needed; the third is 0"});
}

TEST_CASE("inputs whose offsets lie beyond the indices of a corner are left out") {
  const std::string inputs = vertex_input +
                             "<input semantic=\"NORMAL\" source=\"#positions\" offset=\"1\"/>"
                             "<input semantic=\"TEXCOORD\" source=\"#positions\" offset=\"7\"/>";
  const std::string warning =
      "inputs have offsets up to 7, and <p> has 2 for each corner; those beyond are left out";
  for (const std::string& element :
       {"<triangles count=\"1\">" + inputs + "<p>0 1 1 2 2 3</p></triangles>",
        "<polylist count=\"1\">" + inputs + "<vcount>3</vcount><p>0 1 1 2 2 3</p></polylist>"}) {
    const LoadedScene loaded = load_shape(collada_mesh(4, square, element));
    CHECK(mesh_of(loaded).positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    CHECK(mesh_of(loaded).normal_indices == std::vector<Triangle>{{0, 1, 2}});
    CHECK(mesh_of(loaded).normals[0] == Vec3{1, 0, 0});  // the second position; the first is not used
    CHECK(mesh_of(loaded).uvs.empty());
    CHECK(messages(loaded)[0] == warning);
  }
  const LoadedScene lying = load_shape(collada_mesh(
      4, square,
      "<triangles count=\"2\">" + vertex_input +
          "<input semantic=\"NORMAL\" source=\"#positions\" offset=\"1\"/><p>0 1 1 2 2 3</p></triangles>"));
  CHECK(messages(lying)[0] == "count says 2, and <triangles> has 1; all of it is read");
}

}  // namespace twinray
