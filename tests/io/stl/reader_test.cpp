// SPDX-License-Identifier: Apache-2.0
#include "io/stl/reader.h"

#include <fmt/format.h>

#include <cstring>

#include "io/stl/scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

std::string facet(const std::string& third) {
  return "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex " + third +
         "\n endloop\nendfacet\n";
}

struct Read {
  ObjModel model;
  std::vector<Diagnostic> warnings;
};

Read read(const std::string& bytes, bool is_strict = false) {
  WarningList warnings(is_strict);
  ObjModel model = read_stl(bytes, "a.stl", warnings);
  return {std::move(model), warnings.items()};
}

std::string error_of(const std::string& bytes, bool is_strict = false) {
  try {
    read(bytes, is_strict);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A binary file of triangles that lie apart, each with two bytes behind it, whose title is `title`.
std::string binary(std::uint32_t count, const std::string& title = "", std::uint16_t mark = 0) {
  std::string bytes = title;
  bytes.resize(80, ' ');
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = float(i);
    for (const float coordinate : {9.f, 9.f, 9.f, x, 0.f, 0.f, x + 0.5f, 0.f, 0.f, x, 0.5f, 0.25f})
      add(coordinate);
    add(mark);
  }
  return bytes;
}

}  // namespace

TEST_CASE("solids of an ASCII STL file are objects, words in any letters and on any lines") {
  const std::string text = "solid lower part \n" + facet("0 1 0") + facet("0 2 0") +
                           "endsolid lower part\nSOLID\r\n" +
                           "FACET\tNORMAL nan nan nan OUTER LOOP VERTEX +.5 -1e1 0 Vertex 1 0 0 vertex 0 1 0 "
                           "Vertex 0 0 7 EndLoop ENDFACET\nENDSOLID";
  const auto [model, warnings] = read("\xef\xbb\xbf" + text);
  CHECK(warnings.empty());
  CHECK(model.name == "a");
  REQUIRE(model.faces.size() == 2);
  CHECK(model.faces[0].object == "lower part");
  CHECK(model.faces[0].sizes == std::vector<std::uint32_t>{3, 3});
  CHECK(model.faces[1].object.empty());
  CHECK(model.faces[1].sizes == std::vector<std::uint32_t>{4});
  CHECK(model.faces[1].corners[0].position == 6);
  CHECK(model.positions.size() == 10);
  CHECK(model.positions[5] == Vec3{0, 2, 0});
  CHECK(model.positions[6] == Vec3{0.5f, -10, 0});
}

TEST_CASE("triangles of a binary STL file are read, whatever its title says") {
  for (const char* title : {"", "made by a program", "solid of a program that says so"}) {
    const auto [model, warnings] = read(binary(3, title));
    CHECK(warnings.empty());
    CHECK(model.notes.empty());
    REQUIRE(model.faces.size() == 1);
    CHECK(model.faces[0].sizes.size() == 3);
    CHECK(model.positions.size() == 9);
    CHECK(model.positions[8] == Vec3{2, 0.5f, 0.25f});
  }
  CHECK(read(binary(2, "", 7) + "xyz").model.notes ==
        std::vector<std::string>{"attributes of triangles (colors, in some programs), left out: 2",
                                 "bytes behind the last triangle, left out: 3"});
}

TEST_CASE("an STL file that is cut off is not taken for a whole one") {
  const std::string whole = "solid a\n" + facet("0 1 0") + facet("0 2 0") + "endsolid a\n";
  const std::size_t second = 8 + facet("").size() + 5;
  for (const std::size_t size : {second + 7, second + 40, second + facet("0 2 0").size() - 2}) {
    CAPTURE(size);
    CHECK(error_of(whole.substr(0, size)).find("a.stl:") == 0);
  }
  CHECK(error_of(whole.substr(0, whole.rfind("vertex 1 0 0") + 10)) ==
        "a.stl:12:13: the file ends within a facet: it is cut off\n  vertex 1 0\n            ^");
  const auto [model, warnings] = read(whole.substr(0, second));
  CHECK(model.positions.size() == 3);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].message == "the file ends without \"endsolid\": facets may be missing");
  CHECK(error_of(whole.substr(0, second), true).find("endsolid") != std::string::npos);
  const std::string bytes = binary(5);
  CHECK(error_of(bytes.substr(0, bytes.size() - 51)) ==
        "a.stl: the file is neither ASCII STL, which begins with \"solid\", nor binary STL: its head says 5 "
        "triangles, and it has bytes for 3");
}

TEST_CASE("what is wrong with an STL file is an error that says where") {
  const auto in_solid = [](const std::string& text) { return error_of("solid a\n" + text); };
  CHECK(error_of("") == "a.stl: the file is empty");
  CHECK(error_of("solid a\nendsolid a\n") == "a.stl: the file has no triangles");
  CHECK(error_of(binary(0)) == "a.stl: the file has no triangles");
  CHECK(error_of("v 0 0 0").ends_with("nor binary STL: it has less than 84 bytes"));
  CHECK(in_solid("facets\n") ==
        "a.stl:2:1: \"facets\" is not known here; valid are solid, facet and endsolid\n  facets\n  ^");
  CHECK(in_solid("facet normal 0 0 1\nloop")
            .starts_with("a.stl:3:1: \"loop\" is not known here; valid are outer\n"));
  CHECK(in_solid(facet("0 1")).starts_with("a.stl:7:2: a coordinate that is no number: \"endloop\"\n"));
  CHECK(in_solid(facet("0 1 nan")).starts_with("a.stl:6:14: a coordinate that is no number: \"nan\"\n"));
  CHECK(in_solid(facet("0 1e13 0")).starts_with("a.stl:6:12: a coordinate lies beyond +-1e+12\n"));
  CHECK(in_solid(facet("0 1e999 0")).starts_with("a.stl:6:12: a coordinate lies beyond +-1e+12\n"));
  const float too_large = 2e12f;
  for (const float value : {too_large, std::numeric_limits<float>::quiet_NaN()})
    for (const std::size_t coordinate : {0u, 1u, 2u, 8u}) {
      std::string bytes = binary(2);
      std::memcpy(bytes.data() + 84 + 50 + 12 + 4 * coordinate, &value, 4);
      CHECK(error_of(bytes) == "a.stl: a coordinate of triangle 2 lies beyond +-1e+12, or is no number");
    }
  const std::string flat = facet("0 1 0"),
                    cut = flat.substr(0, flat.find("  vertex 1")) + " endloop endfacet\n";
  CHECK(read("solid a\n" + flat + cut + "endsolid").model.small_faces == 1);
}

TEST_CASE("an STL file is a scene, lit by default") {
  const TemporaryFolder folder;
  write_text(folder.file("a.stl"), "solid\n" + facet("0 2 0") + "endsolid\n");
  const LoadedScene loaded = load_stl(folder.file("a.stl"));
  CHECK(loaded.scene.geometry->triangle_count() == 1);
  CHECK(loaded.scene.geometry->bounds().upper == Vec3{1, 2, 0});
  CHECK(loaded.wants_light);
  CHECK(loaded.scene.geometry->mesh(0)->normals.empty());
  CHECK(loaded.scene.geometry->mesh(0)->name == "a");
}

}  // namespace twinray::test
