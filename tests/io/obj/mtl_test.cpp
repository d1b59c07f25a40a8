// SPDX-License-Identifier: Apache-2.0
// What numbers and statements of material files mean.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/textured_material.h"
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
    const auto warnings = load_with_mtl(folder, text + "\nKd 1 1 1").warnings;
    REQUIRE(!warnings.empty());
    CHECK(warnings[0].text() == folder.file("a.mtl") + ": " + name + " of the material \"m\" is " +
                                    text.substr(name.size() + 1) + "; the nearest number in [0, 1] is taken");
  }
  CHECK(load_with_mtl(folder, "Kd 1 0 1\nPr 1\nPm 0\nd 1").warnings.empty());
}

TEST_CASE("a roughness of MTL that is 0 makes a smooth surface, other values of 0 say nothing") {
  const TemporaryFolder folder;
  for (const char* lines :
       {"Pr 0", "Kd .5 .5 .5\nPr 0.0\nPm 0\nPc 0\nillum 1", "Ks .5 .5 .5\nillum 2\nPr 0"}) {
    CAPTURE(lines);
    const LoadedScene loaded = load_with_mtl(folder, "Kd 1 0 0\n" + std::string(lines));
    const auto& smooth = std::get<Principled>(loaded.scene.materials.at(0).model);
    CHECK(smooth.specular_roughness == 0);
    CHECK(smooth.specular_weight == 1);
    CHECK(loaded.warnings.empty());
  }
  CHECK(reflectance_by(folder, "Kd 1 0 0\nPm 0\nPs 0\nPc 0") == Rgb{1, 0, 0});
}

TEST_CASE("a color of MTL beyond its range is the nearest within, with a warning") {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.mtl");
  for (const char* name : {"Kd", "Ks", "Tf"})
    for (const char* color : {"2 0.5 0", "0.5 -1 0"}) {
      const auto warnings = load_with_mtl(folder, fmt::format("{} {}", name, color)).warnings;
      REQUIRE(warnings.size() == 1);
      CHECK(warnings[0].text() ==
            fmt::format("{}: {} of the material \"m\" is {}; the nearest color in [0, 1] "
                        "is taken",
                        file, name, color));
    }
  const auto warnings = load_with_mtl(folder, "Ke 20 -1 0").warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].text() ==
        file + ": Ke of the material \"m\" is 20 -1 0; 0 is taken for what is negative");
  CHECK(load_with_mtl(folder, "Ke 20 1 0").warnings.empty());
}

TEST_CASE("a spectrum of MTL is not read, and grey stands for it") {
  const TemporaryFolder folder;
  const LoadedScene loaded = load_with_mtl(folder, "Kd spectral paper.rfl 2");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "the spectrum of \"Kd\" is not read: 0.5 stands for it");
  CHECK(loaded.warnings[0].place.line == 2);
  CHECK(std::get<Lambert>(loaded.scene.materials.at(0).model).reflectance == Rgb{0.5f, 0.5f, 0.5f});
}

TEST_CASE("a material of which MTL does not say what it looks like is black, with a warning") {
  const TemporaryFolder folder;
  const LoadedScene loaded =
      load_with_mtl(folder, "Ns 20\n\nnewmtl lit\nKe 1 1 1\nnewmtl last one \nillum 2");
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(loaded.warnings[0].message == "nothing says what the material \"m\" reflects (Kd); it is black");
  CHECK(loaded.warnings[0].place.line == 1);
  CHECK(loaded.warnings[1].message ==
        "nothing says what the material \"last one\" reflects (Kd); it is black");
  CHECK(loaded.warnings[1].place.line == 6);
  for (const char* line : {"Kd 0 0 0", "Ks 1 1 1", "Ke 1 1 1", "Tf 1 1 1", "illum 4\nNi 1.5\nd 0.1"})
    CHECK(load_with_mtl(folder, line).warnings.empty());
}

TEST_CASE("an option that would change a picture of MTL and is not read is told") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), Image(1, 1, {1, 1, 1}));
  const auto warnings_of = [&](const std::string& line) { return load_with_mtl(folder, line).warnings; };
  for (const char* line : {"map_Kd -cc on a.exr", "map_Kd -imfchan g a.exr", "map_Ks -type sphere a.exr"}) {
    CAPTURE(line);
    const auto warnings = warnings_of(std::string("Kd 1 1 1\n") + line);
    REQUIRE(warnings.size() == 1);
    const std::string text(line), option = text.substr(7, text.find(' ', 7) - 7);
    CHECK(warnings[0].message == fmt::format("\"{}\" of \"{}\" is left out", option, text.substr(0, 6)));
    CHECK(warnings[0].place.line == 3);
  }
  for (const char* line : {"map_Kd -cc off a.exr", "map_Kd -blendu on a.exr", "map_d -imfchan g a.exr"})
    CHECK(warnings_of(std::string("Kd 1 1 1\n") + line).empty());
}

TEST_CASE("the normals of a map lean as far as its option says") {
  const TemporaryFolder folder;
  write_exr(folder.file("n.exr"), Image(1, 1, {0.75f, 0.25f, 1}));
  const auto normal_by = [&](const std::string& line) {
    const Scene scene = load_with_mtl(folder, "Kd 1 1 1\n" + line).scene;
    REQUIRE(scene.materials[0].normal_map != no_texture);
    return evaluate(scene.textures, scene.materials[0].normal_map, {});
  };
  CHECK(normal_by("norm n.exr") == Rgb{0.75f, 0.25f, 1});
  CHECK(normal_by("norm -bm 0.5 n.exr") == Rgb{0.625f, 0.375f, 1});
  CHECK(normal_by("bump -bm 2 n.exr") == Rgb{1, 0, 1});
}

TEST_CASE("a picture of sheen alone makes a material of MTL a physical one") {
  const TemporaryFolder folder;
  write_exr(folder.file("a.exr"), Image(1, 1, {0.5f, 0.5f, 0.5f}));
  const Scene scene = load_with_mtl(folder, "Kd 1 1 1\nmap_Ps a.exr").scene;
  const auto model =
      std::get<Principled>(textured_model(scene.materials.at(0), scene.textures, {.uv = {0.5f, 0.5f}}));
  CHECK(model.fuzz_weight == 0.5f);
}

TEST_CASE("a comment of MTL is no part of a picture's name, which may have its sign") {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a b.exr", "a#b.exr"}) {
    CAPTURE(name);
    write_exr(folder.file(name), Image(1, 1, {1, 1, 1}));
    for (const char* comment : {"", " # a picture", "\t# a picture", "  #"})
      CHECK(load_with_mtl(folder, fmt::format("map_Kd -s 2 2 {}{}", name, comment)).warnings.empty());
  }
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
  CHECK(load_with_mtl(folder, "\n  # a comment\nsharpness 60\nillum 1\nKa 1 1 1\nKd 1 1 1").warnings.empty());
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
