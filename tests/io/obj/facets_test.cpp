// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("facets of an OBJ file are turned as MTL says, and have a direction where there are coordinates") {
  const TemporaryFolder folder;
  write_text(folder.file("a.mtl"), "newmtl brushed\nKd 1 1 1\nPr 0.5\naniso 0.5\nanisor 0.125\n");
  const auto load = [&](const std::string& face) {
    write_text(folder.file("a.obj"),
               "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
               "usemtl brushed\n" +
                   face + "\n");
    const LoadedScene loaded = load_scene(folder.file("a.obj"));
    CHECK(std::get<Principled>(loaded.scene.materials.at(0).model).specular_roughness_anisotropy == 0.5f);
    CHECK(loaded.scene.materials[0].tangent_degrees == 45);
    return loaded.warnings;
  };
  CHECK(load("f 1/1 2/2 3/3").empty());
  const auto warnings = load("f 1 2 3");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].text() ==
        folder.file("a.mtl") +
            ": the mesh has no texture coordinates, which the direction of its facets goes by; it is "
            "any direction");
}

}  // namespace twinray::test
