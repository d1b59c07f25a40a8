// SPDX-License-Identifier: Apache-2.0
#include "io/three_mf/scene.h"

#include <algorithm>

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/near.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"
#include "tests/support/three_mf_text.h"

namespace twinray {
namespace {

using test::contains;
using test::tetrahedron;
using test::three_mf_model;
using test::three_mf_package;
using test::ZipEntry;

/// A package in a folder of its own.
struct Package {
  explicit Package(const std::string& model, std::vector<ZipEntry> others = {}) {
    test::write_text(path(), three_mf_package(model, std::move(others)));
  }
  std::string path() const { return folder.file("a.3mf"); }
  LoadedScene load(const LoadOptions& options = {}) const { return load_scene(path(), options); }
  /// Behind the package's name.
  std::string error(const LoadOptions& options = {}) const {
    try {
      load(options);
    } catch (const Error& error) {
      return std::string(error.what()).substr(path().size());
    }
    return "";
  }

  test::TemporaryFolder folder;
};

std::string shown(const std::string& resources, const std::string& items) {
  return three_mf_model("<resources>" + resources + "</resources><build>" + items + "</build>");
}

const std::string item = "<item objectid=\"1\"/>";

/// The reflectance of each shape, in their order.
std::vector<Rgb> colors_of(const Scene& scene) {
  std::vector<Rgb> colors;
  for (const ShapeBinding& binding : scene.bindings)
    colors.push_back(std::get<Lambert>(scene.materials[binding.material].model).reflectance);
  return colors;
}

const Rgb red{1, 0, 0}, green{0, 1, 0}, grey{0.5f, 0.5f, 0.5f};
const std::string paints =
    "<basematerials id=\"8\"><base name=\"tomato\" displaycolor=\"#FF0000\"/>"
    "<base name=\"leaf\" displaycolor=\"#00ff0080\"/></basematerials>"
    "<m:colorgroup id=\"9\"><m:color color=\"#00FF00\"/><m:color color=\"#FF0000FF\"/></m:colorgroup>";

}  // namespace

TEST_CASE("a 3MF package shows its items where they stand, z up") {
  const Package package(
      shown(tetrahedron(1, "name=\"part\"") + tetrahedron(2) +
                "<object id=\"3\"><components><component objectid=\"1\"/>"
                "<component objectid=\"2\" transform=\"2 0 0 0 1 0 0 0 1 10 20 30\"/></components></object>",
            "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 100\"/>"));
  const LoadedScene loaded = package.load();
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.assets == std::vector<std::string>{"part", "object 2"});
  CHECK(loaded.summary.triangles == 8);
  CHECK(loaded.summary.unit_name == "millimeter");
  CHECK(loaded.summary.unit_meters == 0.001);
  CHECK(loaded.summary.up_axis == 'Z');
  CHECK(loaded.wants_light);
  // Rows act on: (x, y, z) -> (-y, x, z + 100), and then z up to y up.
  const Aabb first = loaded.scene.geometry->bounds();
  CHECK(first.lower == Vec3{-26, 100, -20});
  CHECK(first.upper == Vec3{0, 137, 0});
}

TEST_CASE("units of 3MF packages are told in metres, and coordinates stay in them") {
  const std::pair<const char*, double> units[] = {{"micron", 1e-6},     {"millimeter", 1e-3},
                                                  {"centimeter", 0.01}, {"inch", 0.0254},
                                                  {"foot", 0.3048},     {"meter", 1}};
  for (const auto& [name, meters] : units) {
    const Package package(
        three_mf_model("<resources>" + tetrahedron(1) + "</resources><build>" + item + "</build>",
                       "unit=\"" + std::string(name) + "\""));
    const LoadedScene loaded = package.load();
    CHECK(loaded.summary.unit_name == name);
    CHECK(loaded.summary.unit_meters == meters);
    CHECK(loaded.scene.geometry->bounds().upper == Vec3{5, 7, 0});
  }
}

TEST_CASE("objects of a 3MF package may lie in other parts of it") {
  const Package package(
      shown("<object id=\"1\"><components><component objectid=\"7\" p:path=\"/3D/Objects/b.model\"/>"
            "</components></object>",
            "<item objectid=\"1\"/><item objectid=\"7\" p:path=\"/3D/objects/B.model\" transform=\"1 0 0 0 1 "
            "0 0 0 "
            "1 50 0 0\"/>"),
      {{"3D/Objects/b.model", three_mf_model("<resources>" + tetrahedron(7) + "</resources><build/>")}});
  const LoadedScene loaded = package.load();
  CHECK(loaded.summary.triangles == 8);
  CHECK(loaded.scene.geometry->bounds().upper.x == 55);
  CHECK(loaded.summary.repeated == 1);
}

TEST_CASE("what a 3MF package shows often is stored once where that is asked for") {
  const Package package(
      shown(tetrahedron(1), item + "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 9 0 0\"/>"));
  const LoadedScene kept = package.load({.instances = InstanceUse::keep});
  CHECK(kept.summary.instances == 2);
  CHECK(kept.summary.triangles == 4);
  const LoadedScene copied = package.load();
  CHECK(copied.summary.instances == 0);
  CHECK(copied.summary.triangles == 8);
  CHECK(kept.scene.geometry->bounds().lower == copied.scene.geometry->bounds().lower);
  CHECK(kept.scene.geometry->bounds().upper == copied.scene.geometry->bounds().upper);
}

TEST_CASE(
    "triangles of 3MF wear materials and colours: their own, their object's, or that of what holds it") {
  const auto colors = [&](const std::string& objects) {
    return colors_of(Package(shown(paints + objects, item)).load().scene);
  };
  CHECK(colors(tetrahedron(1)) == std::vector{grey});
  CHECK(colors(tetrahedron(1, "pid=\"8\" pindex=\"1\"")) == std::vector{green});
  CHECK(colors(tetrahedron(1, "pid=\"9\"", "pid=\"8\" p1=\"0\"")) == std::vector{red, green});
  CHECK(colors(tetrahedron(1, "", "pid=\"9\" p1=\"1\"")) == std::vector{red, grey});
  CHECK(colors(tetrahedron(1, "pid=\"9\"", "p1=\"1\"")) == std::vector{red, green});
  CHECK(colors(tetrahedron(1, "", "p1=\"1\"")) == std::vector{grey});
  CHECK(colors(tetrahedron(2) + "<object id=\"1\" pid=\"8\" pindex=\"1\"><components>"
                                "<component objectid=\"2\"/></components></object>") == std::vector{green});
  const LoadedScene named =
      Package(shown(paints + tetrahedron(1, "pid=\"8\"", "pid=\"9\" p1=\"0\""), item)).load();
  CHECK(named.scene.materials[0].name == "#00FF00");
  CHECK(named.scene.materials[1].name == "tomato");
}

TEST_CASE("a triangle of 3MF whose corners differ in colour is painted") {
  const LoadedScene loaded =
      Package(shown(paints + tetrahedron(1, "pid=\"9\"", "pid=\"9\" p1=\"0\" p2=\"1\" p3=\"0\""), item))
          .load();
  REQUIRE(loaded.scene.textures.size() == 1);
  REQUIRE(loaded.scene.geometry->shapes().size() == 2);
  const Material& painted = loaded.scene.materials[loaded.scene.bindings[0].material];
  CHECK(texture_use(painted, MaterialInput::reflectance));
  CHECK(loaded.scene.geometry->mesh(0)->triangles.size() == 1);
  CHECK(loaded.scene.geometry->mesh(1)->triangles.size() == 3);
}

TEST_CASE("what 3MF has and is not rendered is named") {
  const Package package(
      shown("<m:texture2dgroup id=\"5\" texid=\"4\"><m:tex2coord u=\"0\" v=\"0\"/></m:texture2dgroup>" +
                tetrahedron(1, "pid=\"5\"", "pid=\"5\" p1=\"0\" p2=\"0\" p3=\"0\""),
            item));
  const LoadedScene loaded = package.load();
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "<m:texture2dgroup> is not rendered; its triangles are grey");
  CHECK(colors_of(loaded.scene) == std::vector{grey});
  CHECK(contains(package.error({.strict = true}), "<m:texture2dgroup> is not rendered"));
  const Package beams(
      three_mf_model("<resources>" + tetrahedron(1) + "</resources><build>" + item + "</build>",
                     "requiredextensions=\"p b\" "
                     "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\""));
  CHECK(contains(beams.error(), "the package requires the extension \"b\" (http://schemas.microsoft.com/"));
}

TEST_CASE("a 3MF package that is wrong is refused where it is wrong") {
  const auto error = [](const std::string& objects, const std::string& items = item) {
    return Package(shown(paints + objects, items)).error();
  };
  const auto names = [](const std::string& text, const std::string& message) {
    CAPTURE(text);
    CHECK(text.starts_with("/3D/Model.model:2:"));
    CHECK(contains(text, ": " + message));
  };
  CHECK(contains(error(""), ": there is no object with the id 1 in "));
  const std::string within = "<object id=\"1\"><components><component objectid=\"";
  names(error(within + "1\"/></components></object>"), "the object 1 contains itself");
  names(error(within + "2\"/></components></object><object id=\"2\"><components><component "
                       "objectid=\"1\"/></components></object>"),
        "the object 1 contains itself");
  names(error("<object id=\"1\"/>"), "an <object> holds a <mesh> or <components>");
  names(error(tetrahedron(1) + tetrahedron(1)), "another object has this id");
  names(error(tetrahedron(1), "<item objectid=\"1\" transform=\"1 0 0\"/>"),
        "a transform has 12 numbers; here are 3");
  names(error(tetrahedron(1), "<item objectid=\"1\" transform=\"1 0 x 0\"/>"), "\"x\" is not a number");
  names(error(tetrahedron(1), "<item objectid=\"1\" p:path=\"/no.model\"/>"),
        "the package has no part \"/no.model\"");
  CHECK(contains(Package(three_mf_model("<resources/><build/>", "unit=\"mile\"")).error(),
                 "\"mile\" is no unit of 3MF; valid are micron, millimeter,"));
  CHECK(Package(three_mf_model("<resources/><build/>")).error() ==
        ": what the package's <build> shows has no triangles");
  CHECK(contains(Package("<html/>").error(), "not 3MF: the root element is <html>, not <model>"));
}

TEST_CASE("a 3MF package whose objects multiply is refused before they are all made") {
  std::string objects = tetrahedron(1);
  for (int id = 2; id < 60; ++id) {
    const std::string component = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += "<object id=\"" + std::to_string(id) + "\"><components>" + component + component +
               "</components></object>";
  }
  CHECK(contains(Package(shown(objects, "<item objectid=\"59\"/>")).error(),
                 "the package shows more than 1000000 objects"));
  std::string nested = tetrahedron(1);
  for (int id = 2; id < 300; ++id)
    nested += "<object id=\"" + std::to_string(id) + "\"><components><component objectid=\"" +
              std::to_string(id - 1) + "\"/></components></object>";
  CHECK(contains(Package(shown(nested, "<item objectid=\"299\"/>")).error(),
                 "components are nested deeper than 100"));
}

}  // namespace twinray
