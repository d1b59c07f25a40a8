// SPDX-License-Identifier: Apache-2.0
// Which statements and corners of OBJ files are read.
#include "io/obj/statements.h"

#include "tests/support/catch.h"
#include "tests/support/obj_text.h"

namespace twinray::test {
namespace {

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("a corner of an OBJ file may end with the slashes of what it leaves out") {
  const LoadedScene loaded =
      load_obj_text(vertices + "vt 0 0\nf 1/ 2/ 3/\nf 1// 3// 4//\nf 1/1/ 2/1/ 3/1/\n");
  const Mesh& first = *loaded.scene.geometry->mesh(0);
  CHECK(first.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(first.uvs.empty());
  CHECK(loaded.scene.geometry->mesh(1)->uv_indices == std::vector<Triangle>{{0, 0, 0}});
  CHECK(loaded.warnings.empty());
}

TEST_CASE("a statement that OBJ does not have is named, and what is left out is counted") {
  const LoadedScene loaded = load_obj_text(
      vertices + "vertex 1 2 3\ns 1\n  l 1 2\nl 2 3\np 1 # v\nf 1 2 3\ncurv 0 1 \\\n1 2\nvertex\nF 1 3 4\n");
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(loaded.warnings[0].text() ==
        "scene.obj:5:1: \"vertex\" is not known; it is left out (2 times)\n  vertex 1 2 3\n  ^");
  CHECK(loaded.warnings[1].place.line == 14);
  CHECK(loaded.warnings[1].message == "\"F\" is not known; it is left out");
  const std::vector<std::string> notes{"lines (\"l\") are left out: 2", "points (\"p\") are left out: 1",
                                       "curves (\"curv\") are left out: 1"};
  CHECK(loaded.summary.notes == notes);
}

}  // namespace twinray::test
