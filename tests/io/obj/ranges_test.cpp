// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {

TEST_CASE("a number of MTL beyond its range is the nearest within, with a warning") {
  const TemporaryFolder folder;
  write_text(folder.file("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  const auto warnings_of = [&](const std::string& lines) {
    write_text(folder.file("a.mtl"), "newmtl m\n" + lines + "\n");
    return load_scene(folder.file("a.obj")).warnings;
  };
  for (const char* line : {"Pr 2", "Pm -1", "Ps 1.5", "Pc -0.5", "Pcr 3", "aniso 7", "d 2"}) {
    const std::string text(line), name = text.substr(0, text.find(' '));
    CAPTURE(line);
    const auto warnings = warnings_of(text);
    REQUIRE(!warnings.empty());
    CHECK(warnings[0].text() == folder.file("a.mtl") + ": " + name + " of the material \"m\" is " +
                                    text.substr(name.size() + 1) + "; the nearest number in [0, 1] is taken");
  }
  CHECK(warnings_of("Pr 1\nPm 0\nd 1").empty());
}

}  // namespace twinray::test
