// SPDX-License-Identifier: Apache-2.0
#include "io/collada/transform.h"

#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/near.h"

namespace twinray {
namespace {

/// Rounding of a product of a few matrices to float.
/// Where a node with these transform elements puts a point.
Vec3 moved_point(const std::string& elements, const Vec3& p) {
  const auto xml =
      XmlDocument::parse("<COLLADA version=\"1.4.1\"><node>" + elements + "</node></COLLADA>", "scene.dae");
  ColladaDocument document(*xml, {.strict = true});
  return read_node_transform(xml->root().required_child("node"), document).point(p);
}

void check_moved(const Vec3& a, const Vec3& b) { test::check_near(a, b, 2e-6f); }

const std::string triangle_instance = "<instance_geometry url=\"#shape\"/>";

/// The second vertex of the triangle, (1, 0, 0) in its own coordinates.
Vec3 second_vertex(const std::string& nodes, const std::string& up_axis = "Y_UP",
                   const std::string& more = "") {
  return mesh_of(load_collada(collada_text(collada_triangle() + more, nodes, up_axis))).positions[1];
}

}  // namespace

TEST_CASE("the elements of a node act from the last to the first") {
  CHECK(moved_point("<translate>10 0 0</translate><scale>2 3 4</scale>", {1, 1, 1}) == Vec3{12, 3, 4});
  CHECK(moved_point("<scale>2 3 4</scale><translate>10 0 0</translate>", {1, 1, 1}) == Vec3{22, 3, 4});
  check_moved(
      moved_point("<translate>1 2 3</translate><rotate>0 0 1 90</rotate><scale>2 2 2</scale>", {1, 0, 0}),
      {1, 4, 3});
}

TEST_CASE("a matrix is written row by row") {
  CHECK(moved_point("<matrix>1 2 3 4 5 6 7 8 9 10 11 12 0 0 0 1</matrix>", {1, 10, 100}) ==
        Vec3{325, 773, 1221});
}

TEST_CASE("the last row of a matrix may be off by rounding, and no more") {
  const auto with_row = [](const std::string& row) {
    return "<matrix>1 0 0 4 0 1 0 5 0 0 1 6 " + row + "</matrix>";
  };
  CHECK(moved_point(with_row("1e-5 -1e-5 0.00000999 0.99999"), {1, 1, 1}) == Vec3{5, 6, 7});
  for (const char* row : {"1.1e-5 0 0 1", "0 0 -1.1e-5 1", "0 0 0 1.00002", "0 0 0 0"})
    CHECK_THROWS_AS(moved_point(with_row(row), {1, 1, 1}), Error);
}

TEST_CASE("several matrices multiply") {
  const std::string shift = "<matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>";
  const std::string stretch = "<matrix>2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1</matrix>";
  CHECK(moved_point(shift + stretch, {1, 1, 1}) == Vec3{7, 2, 2});
  CHECK(moved_point(stretch + shift, {1, 1, 1}) == Vec3{12, 2, 2});
}

TEST_CASE("a rotation is axis and degrees") {
  check_moved(moved_point("<rotate>1 0 0 90</rotate>", {0, 1, 0}), {0, 0, 1});
  check_moved(moved_point("<rotate>0 2 0 90</rotate>", {0, 0, 1}), {1, 0, 0});
  check_moved(moved_point("<rotate>1 1 1 120</rotate>", {1, 0, 0}), {0, 1, 0});
  CHECK(moved_point("<rotate>0 0 0 0</rotate>", {1, 2, 3}) == Vec3{1, 2, 3});
}

TEST_CASE("a lookat stands at the eye and looks along its -z") {
  const std::string look = "<lookat>1 2 3 1 2 -7 0 1 0</lookat>";
  check_moved(moved_point(look, {0, 0, 0}), {1, 2, 3});
  check_moved(moved_point(look, {0, 0, -10}), {1, 2, -7});
  check_moved(moved_point(look, {0, 1, 0}), {1, 3, 3});
  const std::string aside = "<lookat>0 0 0 5 0 0 1 1 0</lookat>";
  check_moved(moved_point(aside, {0, 0, -1}), {1, 0, 0});
  check_moved(moved_point(aside, {0, 1, 0}), {0, 1, 0});
  check_moved(moved_point(aside, {1, 0, 0}), {0, 0, 1});
}

TEST_CASE("a skew turns its first axis towards the second, along the second") {
  check_moved(moved_point("<skew>45 0 1 0 1 0 0</skew>", {0, 1, 0}), {1, 1, 0});
  check_moved(moved_point("<skew>45 0 1 0 1 0 0</skew>", {3, 0, 4}), {3, 0, 4});
  check_moved(moved_point("<skew>-45 0 2 0 3 0 0</skew>", {0, 1, 0}), {-1, 1, 0});
}

TEST_CASE("nodes act within each other") {
  CHECK(second_vertex("<node><translate>10 0 0</translate><node><scale>3 1 1</scale>" + triangle_instance +
                      "</node></node>") == Vec3{13, 0, 0});
}

TEST_CASE("a node instanced twice gives two meshes, each where it belongs") {
  const std::string library =
      "<library_nodes><node id=\"twig\"><scale>2 1 1</scale>" + triangle_instance + "</node></library_nodes>";
  const LoadedScene loaded =
      load_collada(collada_text(collada_triangle() + library,
                                "<node><translate>0 0 1</translate><instance_node url=\"#twig\"/></node>"
                                "<node><translate>0 0 2</translate><instance_node url=\"#twig\"/></node>"));
  REQUIRE(loaded.scene.geometry->shapes().size() == 2);
  CHECK(mesh_of(loaded, 0).positions[1] == Vec3{2, 0, 1});
  CHECK(mesh_of(loaded, 1).positions[1] == Vec3{2, 0, 2});
}

TEST_CASE("each up axis is turned to Y") {
  const std::string node = "<node><translate>1 2 3</translate>" + triangle_instance + "</node>";
  CHECK(second_vertex(node, "Y_UP") == Vec3{2, 2, 3});
  CHECK(second_vertex(node, "Z_UP") == Vec3{-2, 3, 2});
  CHECK(second_vertex(node, "X_UP") == Vec3{2, 2, -3});
}

TEST_CASE("turning the up axis keeps the front of a triangle the front") {
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    const LoadedScene loaded =
        load_collada(collada_text(collada_triangle(), "<node>" + triangle_instance + "</node>", axis));
    CHECK(mesh_of(loaded).triangles[0] == Triangle{0, 1, 2});
    CHECK(loaded.summary.up_axis == axis[0]);
  }
}

TEST_CASE("instances that multiply without end are refused") {
  std::string library = "<library_nodes>";
  for (int i = 0; i < 40; ++i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    library += "<node id=\"n" + std::to_string(i) + "\">" + next + next + "</node>\n";
  }
  library += "<node id=\"n40\"/></library_nodes>";
  CHECK(collada_error(collada_text(library, "<node><instance_node url=\"#n0\"/></node>"))
            .find("the scene has more than 4194304 nodes, instances included") != std::string::npos);
}

TEST_CASE("a long chain of instances is refused") {
  std::string library = "<library_nodes>";
  for (int i = 0; i < 300; ++i)
    library += "<node id=\"n" + std::to_string(i) + "\"><instance_node url=\"#n" + std::to_string(i + 1) +
               "\"/></node>\n";
  library += "<node id=\"n300\"/></library_nodes>";
  CHECK(collada_error(collada_text(library, "<node><instance_node url=\"#n0\"/></node>"))
            .find("nodes are nested more than 200 deep") != std::string::npos);
}

}  // namespace twinray
