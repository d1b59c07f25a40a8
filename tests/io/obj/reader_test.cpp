// SPDX-License-Identifier: Apache-2.0
#include "io/obj/reader.h"

#include "tests/support/catch.h"
#include "tests/support/obj_text.h"

namespace twinray::test {

TEST_CASE("a corner whose normal or texture coordinates there are not goes without them") {
  const auto warned = [](const std::string& text) {
    const LoadedScene loaded = load_obj_text(text);
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.scene.geometry->triangle_count() == 1);
    return loaded.warnings[0].text();
  };
  CHECK(warned(obj_square + "\r\nf 1/-1 2/-1 3/-1\r\n")
            .starts_with("scene.obj:6:1: there is no element -1 among the 0 texture coordinates: 0 stands "));
  CHECK(warned(obj_square + "f 1/2 2/2 3/2\n")
            .starts_with("scene.obj:5:1: there is no element 2 among the 0 texture coordinates: 0 stands "));
  CHECK(
      warned(obj_square + "vn 0 0 1\nf 1//1 2//7 3//5\n")
          .starts_with("scene.obj:6:1: there is no element 7 among the 1 normals: those of the triangles "));
  // Of the corner with a normal it stays.
  const LoadedScene loaded = load_obj_text(obj_square + "vn 0 0.6 0.8\nvt 0.5 0.25\nf 1/1/1 2/-2/-2 3/3/3\n");
  CHECK(loaded.warnings.size() == 4);
  const Mesh& mesh = mesh_of(loaded, 0);
  CHECK(mesh.normals[mesh.normal_indices[0][0]] == Vec3{0, 0.6f, 0.8f});
  for (const int corner : {1, 2}) {
    CHECK(mesh.normals[mesh.normal_indices[0][corner]] == Vec3{0, 0, 1});
    CHECK(mesh.uvs[mesh.uv_indices[0][corner]] == Vec2{0, 0});
  }
  CHECK(mesh.uvs[mesh.uv_indices[0][0]] == Vec2{0.5f, 0.25f});
}

TEST_CASE("what is wrong with a face of an OBJ file is an error with its line") {
  CHECK(obj_error(obj_square + "f 1 2 -9\n") ==
        "scene.obj:5:1: there is no element -9 among the 4 vertices so far\n  f 1 2 -9\n  ^");
  for (const std::string word : {"0", "1.5", "3x", "/1", "1/2//", "1/2/3/4", "4294967297", "a", "+1"})
    CHECK(obj_error(obj_square + "f 1 " + word + " 2\n")
              .starts_with("scene.obj:5:1: \"" + word +
                           "\" is no corner of a face; valid are V, V/T, V//N and"));
  CHECK(obj_error("f 1 2 5\nf 1 2 6\nf 1 6 2\n" + obj_square) ==
        "scene.obj:2:1: there is no element 6 among the 4 vertices\n  f 1 2 6\n  ^");
  CHECK(obj_error(obj_square + "l 1 2\n") == "scene.obj: the file has no faces (\"f\")");
  CHECK(obj_error(obj_square + "f 1 2\n") == "scene.obj: no face of the file has three corners");
  CHECK(obj_error("\xff\xfe f").find("UTF-16") != std::string::npos);
  std::string face = "f";
  for (int i = 0; i < 10001; ++i) face += " 1";
  CHECK(obj_error(obj_square + face).find("a face of 10001 corners; 10000 are the most") !=
        std::string::npos);
  CHECK(obj_error("v 1e30 0 0\n") == "scene.obj:1:1: a coordinate lies beyond +-1e+12\n  v 1e30 0 0\n  ^");
}

}  // namespace twinray::test
