// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/mesh.h"

#include "tests/support/catch.h"
#include "tests/support/text.h"

namespace twinray {
namespace {

using test::contains;
std::vector<ThreeMfPiece> pieces_of(const std::string& vertices, const std::string& triangles) {
  const auto document = XmlDocument::parse(
      "<r><m:colorgroup id=\"2\"><m:color color=\"#ff0000\"/><m:color "
      "color=\"#00ff00\"/></m:colorgroup><mesh>"
      "<vertices>" +
          vertices + "</vertices><triangles>" + triangles + "</triangles></mesh></r>",
      "a.model");
  WarningList warnings(false);
  const ThreeMfProperties properties(document->root(), warnings);
  return read_pieces(document->root().required_child("mesh"), "a", properties, {});
}

std::string mesh_error(const std::string& vertices, const std::string& triangles) {
  try {
    pieces_of(vertices, triangles);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const std::string square_vertices =
    "<vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1e0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"+1\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"-0.5\"/>";

}  // namespace

TEST_CASE("triangles of a 3MF mesh that look alike are a piece, with the vertices that they use") {
  const auto pieces = pieces_of(square_vertices,
                                "<triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"2\" p1=\"1\"/>"
                                "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
                                "<triangle v1=\"3\" v2=\"2\" v3=\"1\" pid=\"2\" p1=\"1\" p2=\"1\"/>");
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].mesh.name == "a");
  CHECK(pieces[0].mesh.positions == std::vector<Vec3>{{1, 0, 0}, {1, 1, 0}, {0, 1, -0.5f}});
  CHECK(pieces[0].mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}});
  REQUIRE(pieces[0].property);
  CHECK(pieces[0].property->color == Rgb{0, 1, 0});
  CHECK_FALSE(pieces[1].property);
  CHECK(pieces[1].mesh.positions.size() == 3);
}

TEST_CASE("corners of a 3MF triangle that differ in colour have vertices of their own") {
  const auto pieces =
      pieces_of(square_vertices,
                "<triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"2\" p1=\"1\" p2=\"0\" p3=\"0\"/>"
                "<triangle v1=\"1\" v2=\"3\" v3=\"0\" pid=\"2\" p1=\"0\" p2=\"0\" p3=\"1\"/>");
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}});
  CHECK(pieces[0].mesh.positions[3] == Vec3{1, 0, 0});
  const Rgb red{1, 0, 0}, green{0, 1, 0};
  CHECK(pieces[0].colors == std::vector{green, red, red, red, red, green});
}

TEST_CASE("vertices and triangles of 3MF that are none are refused where they stand") {
  const auto names = [](const std::string& text, const std::string& message) {
    CAPTURE(text);
    CHECK(text.starts_with("a.model:1:"));
    CHECK(contains(text, message));
  };
  names(mesh_error("<vertex x=\"0,5\" y=\"0\" z=\"0\"/>", ""),
        "\"0,5\" is no coordinate; valid are finite numbers");
  names(mesh_error("<vertex x=\"0\" y=\"nan\" z=\"0\"/>", ""), "\"nan\" is no coordinate");
  names(mesh_error("<vertex x=\"0\" y=\"0\"/>", ""), "z");
  names(mesh_error(square_vertices, "<triangle v1=\"0\" v2=\"1\" v3=\"4\"/>"),
        "the index 4 is out of range; there are 4 vertices");
  names(mesh_error(square_vertices, "<triangle v1=\"0\" v2=\"1\"/>"), "v3");
  names(mesh_error(square_vertices, "<triangle v1=\"0\" v2=\"-1\" v3=\"2\"/>"), "-1");
  names(mesh_error(square_vertices, "<triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"2\" p1=\"2\"/>"),
        "the index 2 is out of range; the group 2 has 2");
}

}  // namespace twinray
