// SPDX-License-Identifier: Apache-2.0
// What numbers and statements of material files mean.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

/// A triangle whose material has these lines.
LoadedScene load_with_mtl(const TemporaryFolder& folder, const std::string& lines) {
  write_text(folder.file("a.obj"),
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  write_text(folder.file("a.mtl"), "newmtl m\n" + lines + "\n");
  return load_scene(folder.file("a.obj"));
}

Rgb reflectance_by(const TemporaryFolder& folder, const std::string& lines) {
  const LoadedScene loaded = load_with_mtl(folder, lines);
  CHECK(loaded.warnings.empty());
  return std::get<Lambert>(loaded.scene.materials.at(0).model).reflectance;
}

}  // namespace

TEST_CASE("a number of MTL beyond its range is the nearest within, with a warning") {
  const TemporaryFolder folder;
  for (const char* line : {"Pr 2", "Pm -1", "Ps 1.5", "Pc -0.5", "Pcr 3", "aniso 7", "d 2"}) {
    const std::string text(line), name = text.substr(0, text.find(' '));
    CAPTURE(line);
    const auto warnings = load_with_mtl(folder, text).warnings;
    REQUIRE(!warnings.empty());
    CHECK(warnings[0].text() == folder.file("a.mtl") + ": " + name + " of the material \"m\" is " +
                                    text.substr(name.size() + 1) + "; the nearest number in [0, 1] is taken");
  }
  CHECK(load_with_mtl(folder, "Pr 1\nPm 0\nd 1").warnings.empty());
}

TEST_CASE("colors of MTL may be CIE's") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& line, const Rgb& expected) {
    const Rgb found = reflectance_by(folder, line);
    CAPTURE(line, found.r, found.g, found.b);
    const Rgb difference = found - expected;
    CHECK(std::max({std::fabs(difference.r), std::fabs(difference.g), std::fabs(difference.b)}) < 2e-4f);
  };
  check("Kd xyz 0.47523 0.5 0.54453", {0.5f, 0.5f, 0.5f});
  check("Kd xyz 0.20620 0.10632 0.00967", {0.5f, 0, 0});
  CHECK(reflectance_by(folder, "Kd xyz 0.5") == reflectance_by(folder, "Kd xyz 0.5 0.5 0.5"));
}

TEST_CASE("what a material file says that is not known is named") {
  const TemporaryFolder folder;
  for (const char* word : {"map_Tr", "map_opacity", "Kdd"}) {
    const auto warnings = load_with_mtl(folder, fmt::format("Kd 1 1 1\n{} a.png", word)).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].message == fmt::format("\"{}\" is not known; it is left out", word));
    CHECK(warnings[0].place.line == 3);
  }
  CHECK(load_with_mtl(folder, "\n  # a comment\nsharpness 60\nillum 1\nKa 1 1 1\n").warnings.empty());
}

TEST_CASE("a picture of gloss is multiplied by its color, which may be left out") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), Image(1, 1, {1, 0.5f, 0.25f}));
  const auto gloss = [&](const std::string& lines) {
    const Scene scene = load_with_mtl(folder, "illum 2\n" + lines + "map_Ks a.exr").scene;
    const auto& model = std::get<Principled>(scene.materials.at(0).model);
    return evaluate(scene.textures, scene.materials[0].textures.at(0).texture, {{0.5f, 0.5f}}) *
           model.specular_weight;
  };
  CHECK(gloss("") == Rgb{1, 0.5f, 0.25f});
  CHECK(gloss("Ks 0.25 0 0.125\n") == Rgb{0.5f, 0, 0.0625f});
  CHECK(load_with_mtl(folder, "illum 3\nKs 1 1 1\nmap_Ks a.exr").warnings.at(0).message ==
        "pictures of what mirrors (map_Ks) are left out");
}

}  // namespace twinray::test
