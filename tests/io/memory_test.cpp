// SPDX-License-Identifier: Apache-2.0
// What reading a file takes at its worst moment, the scene included.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/collada_text.h"
#include "tests/support/counted_memory.h"
#include "tests/support/temporary_folder.h"

namespace twinray::test {
namespace {

constexpr std::size_t most_factor = 4;  ///< Of the file's size, for a file of more than a megabyte.

/// A curved sheet of side x side vertices with a normal each, as `kind`, cut into `parts` primitive elements.
std::string sheet(int side, const std::string& kind, int parts) {
  std::string positions, normals;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = double(x) / side, v = double(y) / side;
      positions += fmt::format("{:.6f} {:.6f} {:.6f} ", u, v, u * u - v * v);
      normals += fmt::format("{:.6f} {:.6f} 1 ", -2 * u, 2 * v);
    }
  std::string primitives;
  for (int part = 0; part < parts; ++part) {
    std::string p, vcount;
    int polygons = 0;
    const auto corner = [&](int i) { p += fmt::format("{0} {0} ", i); };
    for (int y = part * (side - 1) / parts; y < (part + 1) * (side - 1) / parts; ++y)
      for (int x = 0; x + 1 < side; ++x) {
        const int a = y * side + x, b = a + 1, c = b + side, d = a + side;
        for (const int i : {a, b, c}) corner(i);
        if (kind == "triangles")
          for (const int i : {a, c}) corner(i);
        corner(d);
        vcount += "4 ";
        polygons += kind == "triangles" ? 2 : 1;
      }
    primitives += fmt::format(
        "<{0} count=\"{1}\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>"
        "<input semantic=\"NORMAL\" source=\"#normals\" offset=\"1\"/>{2}<p>{3}</p></{0}>\n",
        kind, polygons, kind == "polylist" ? "<vcount>" + vcount + "</vcount>" : "", p);
  }
  return collada_text(
      collada_mesh(side * side, positions, collada_source("normals", side * side, normals) + primitives),
      collada_shape_node());
}

/// The sheet as a skin of two joints, each vertex moved by both.
std::string skinned(const std::string& sheet, int vertices) {
  const auto source = [](const std::string& id, const std::string& array) {
    return fmt::format(
        "<source id=\"{0}\">{1}<technique_common><accessor source=\"#{0}-array\" count=\"2\" "
        "stride=\"1\"><param name=\"A\"/></accessor></technique_common></source>",
        id, array);
  };
  std::string vcount, v;
  for (int i = 0; i < vertices; ++i) vcount += "2 ", v += "0 0 1 1 ";
  const std::string identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ";
  const std::string controller =
      "<library_controllers><controller id=\"c\"><skin source=\"#shape\">" +
      source("j", "<Name_array id=\"j-array\" count=\"2\">a b</Name_array>") +
      source("b", "<float_array id=\"b-array\" count=\"32\">" + identity + identity + "</float_array>") +
      source("w", "<float_array id=\"w-array\" count=\"2\">0.25 0.75</float_array>") +
      "<joints><input semantic=\"JOINT\" source=\"#j\"/><input semantic=\"INV_BIND_MATRIX\" "
      "source=\"#b\"/></joints><vertex_weights count=\"" +
      std::to_string(vertices) +
      "\"><input semantic=\"JOINT\" source=\"#j\" offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#w\" "
      "offset=\"1\"/><vcount>" +
      vcount + "</vcount><v>" + v + "</v></vertex_weights></skin></controller></library_controllers>\n";
  std::string text = sheet;
  const std::string instance = "<instance_geometry url=\"#shape\"/></node>";
  text.replace(text.find(instance), instance.size(),
               "<instance_controller url=\"#c\"/></node><node sid=\"a\"/><node sid=\"b\"/>");
  return text.insert(text.find("<library_visual_scenes>"), controller);
}

/// The file's size, and what reading it takes at most.
struct Reading {
  std::size_t file, memory, triangles;
};

Reading read(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.file("sheet.dae");
  std::ofstream(path) << text;
  const PeakMemory peak;
  const LoadedScene loaded = load_scene(path);
  return {text.size(), peak.bytes(), loaded.scene.geometry->triangle_count()};
}

}  // namespace

TEST_CASE("reading a file of megabytes takes at most four times its size") {
  constexpr int side = 400;
  for (const char* kind : {"triangles", "polylist"})
    for (const int parts : {1, 20}) {
      const Reading reading = read(sheet(side, kind, parts));
      CAPTURE(kind, parts, reading.file, reading.memory);
      REQUIRE(reading.file > 5'000'000);
      CHECK(reading.triangles == 2 * (side - 1) * (side - 1));
      CHECK(reading.memory <= most_factor * reading.file);
      CHECK(reading.memory > reading.file);  // the text itself: so something is counted
    }
}

TEST_CASE("reading a skin takes at most four times the size of its file") {
  constexpr int side = 400;
  const Reading reading = read(skinned(sheet(side, "triangles", 1), side * side));
  CAPTURE(reading.file, reading.memory);
  CHECK(reading.triangles == 2 * (side - 1) * (side - 1));
  CHECK(reading.memory <= most_factor * reading.file);
  CHECK(reading.memory > reading.file);
}

}  // namespace twinray::test
