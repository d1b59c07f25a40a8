// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/parser.h"

#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"

namespace twinray {
namespace {

using test::load_pbrt_text;
using test::load_pbrt_world;
using test::pbrt_triangle;

/// All statements of a text, by name.
std::string names_in(const std::string& text) {
  const PbrtFiles files("a.pbrt");
  PbrtParser parser({"a.pbrt", text}, files);
  PbrtStatement statement;
  std::string names;
  while (parser.next(statement)) names += std::string(statement.name) + " ";
  return names;
}

std::string error_of(const std::string& text, const test::PbrtTexts& files = {}) {
  try {
    load_pbrt_text(text, {}, files);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

PbrtParameters parameters_of(const std::string& text) {
  static std::vector<std::unique_ptr<PbrtFile>> kept;
  kept.push_back(std::make_unique<PbrtFile>(PbrtFile{"a.pbrt", text}));
  PbrtLexer lexer(*kept.back());
  PbrtParameters parameters;
  parameters.clear(lexer.next().place);
  parameters.read(lexer);
  return parameters;
}

}  // namespace

TEST_CASE("comments, line ends and brackets part pbrt's words") {
  CHECK(names_in("Translate 1 2 3#one\r\nScale 1 1 1 # \"two\n\t Rotate[ 90 0 0 1]Identity") ==
        "Translate Scale Rotate Identity ");
  CHECK(names_in("") == "");
  CHECK(names_in("# nothing else") == "");
  CHECK(names_in("\xef\xbb\xbfTranslate 1 2 3") == "Translate ");  // Some editors begin UTF-8 so.
}

TEST_CASE("every type of pbrt's parameters is read, with brackets and without") {
  const PbrtParameters p = parameters_of(
      "\"float a\" 1.5 \"float b\" [ 1 2e-1 -.5 +3. ] \"integer c\" [ -7 ] \"bool d\" true \"bool e\" [ "
      "false ]"
      "\"string f\" \"x y\" \"string g\" [ \"1\" \"2\" ] \"texture h\" \"wood\" \"point3 i\" [ 1 2 3 ]"
      "\"vector2 j\" [ 4 5 ] \"normal k\" [ 0 0 1 0 1 0 ] \"rgb l\" [ .1 .2 .3 ] \"spectrum m\" [ 400 1 700 "
      "2 ]"
      "\"spectrum n\" \"metal-Au-eta\" \"blackbody o\" 5500 \"point q\" [ 7 8 9 ]");
  CHECK(p.real("a", 0) == 1.5f);
  const auto b = p.reals("b");
  CHECK(std::vector<float>(b.begin(), b.end()) == std::vector<float>{1, 0.2f, -0.5f, 3});
  CHECK(p.integer("c", 0) == -7);
  CHECK(p.flag("d", false));
  CHECK_FALSE(p.flag("e", true));
  CHECK(p.text("f", "") == "x y");
  CHECK(p.texts("g").size() == 2);
  CHECK(p.text(*p.find("h")) == "wood");
  CHECK(p.point("i", {}) == Vec3{1, 2, 3});
  CHECK(p.tuples("j", 2).size() == 2);
  CHECK(p.tuples("k", 3).size() == 6);
  CHECK(p.find("l")->type == PbrtType::rgb);
  CHECK(p.reals(*p.find("m"))[3] == 2);
  CHECK(p.text(*p.find("n")) == "metal-Au-eta");
  CHECK(p.reals(*p.find("o"))[0] == 5500);
  CHECK(p.point("q", {}) == Vec3{7, 8, 9});
  CHECK(p.real("none", 42) == 42);
}

TEST_CASE("escapes stand for letters in pbrt's strings") {
  CHECK(parameters_of("\"string a\" \"\\\"b\\\\\\n\"").text("a", "") == "\"b\\\n");
}

TEST_CASE("what is no statement of pbrt's format is an error that shows the place") {
  CHECK(error_of(std::string("Identity\n\0\0", 11))
            .starts_with("scene.pbrt:2:1: \"\\0\\0\" is not a directive"));
  CHECK(error_of("WorldBegin\nSheap \"sphere\"") ==
        "scene.pbrt:2:1: \"Sheap\" is not a directive of pbrt's format; Shape is the nearest one\n  Sheap "
        "\"sphere\"\n  ^");
  CHECK(error_of("Translate 1 2") ==
        "scene.pbrt:1:14: the end of the file stands where Translate needs its number 3 of 3\n  Translate 1 "
        "2\n               ^");
  CHECK(error_of("Scale 1 1,5 1") == "scene.pbrt:1:9: \"1,5\" is not a number\n  Scale 1 1,5 1\n          ^");
  CHECK(error_of("Scale 1 nan 1") == "scene.pbrt:1:9: \"nan\" is not a number\n  Scale 1 nan 1\n          ^");
  CHECK(
      error_of("Scale 1 1e999 1").starts_with("scene.pbrt:1:9: \"1e999\" is too large; numbers lie within"));
  CHECK(
      error_of("WorldBegin Shape \"sphere\n")
          .starts_with("scene.pbrt:1:18: this string does not end on its line; a quotation mark is missing"));
  CHECK(error_of("WorldBegin Shape \"sphere\" \"float radius\" [ 1")
            .starts_with("scene.pbrt:1:27: the list of \"radius\" does not end; ] is missing"));
  CHECK(
      error_of("WorldBegin Shape \"sphere\" \"radius\" 1")
          .starts_with("scene.pbrt:1:27: the string \"radius\" is not the type and the name of a parameter"));
  CHECK(
      error_of("WorldBegin Shape \"sphere\" \"flota radius\" 1")
          .starts_with("scene.pbrt:1:27: the string \"flota radius\": there is no type \"flota\"; valid are "
                       "float, integer, bool"));
  CHECK(error_of("WorldBegin Shape \"sphere\" \"integer radius\" 1")
            .starts_with("scene.pbrt:1:27: \"radius\" is of type integer here; valid is float"));
  CHECK(error_of("WorldBegin Shape \"sphere\" \"float radius\" [ 1 2 ]")
            .starts_with("scene.pbrt:1:27: \"radius\" has 2 values; it needs one"));
  CHECK(error_of("WorldBegin Shape \"sphere\" \"float radius\" -1")
            .starts_with("scene.pbrt:1:27: \"radius\" is -1; it must lie in [1e-12, 1e+12]"));
  CHECK(error_of("WorldBegin Shape \"trianglemesh\" \"point3 P\" [ 1 2 3 4 ]")
            .starts_with("scene.pbrt:1:33: \"point3 P\" has 4 numbers, which do not come in threes"));
}

TEST_CASE("a statement in the wrong block, or an end without a beginning, is an error") {
  CHECK(error_of(pbrt_triangle).starts_with("scene.pbrt:1:1: Shape belongs behind WorldBegin"));
  CHECK(error_of("WorldBegin Film \"rgb\"").starts_with("scene.pbrt:1:12: Film belongs before WorldBegin"));
  CHECK(error_of("WorldBegin\nWorldBegin")
            .starts_with("scene.pbrt:2:1: WorldBegin stands there a second time"));
  CHECK(error_of("WorldBegin AttributeEnd")
            .starts_with("scene.pbrt:1:12: AttributeEnd ends what nothing began"));
  CHECK(error_of("WorldBegin\nAttributeBegin").starts_with("scene.pbrt:2:1: this AttributeBegin has no end"));
  CHECK(error_of("WorldBegin\nObjectBegin \"a\"\nAttributeEnd")
            .starts_with("scene.pbrt:3:1: AttributeEnd stands where the ObjectBegin of line 2 of scene.pbrt "
                         "should be ended first"));
}

TEST_CASE("a parameter that nobody asks for is named with the nearest one that is known") {
  const LoadedScene loaded = load_pbrt_world("Shape \"sphere\" \"float raduis\" 2 \"string colour\" \"red\"");
  REQUIRE(loaded.warnings.size() == 2);
  CHECK(
      loaded.warnings[0].text() ==
      "scene.pbrt:2:16: \"float raduis\" is not known here, and left out; \"radius\" is\n  Shape \"sphere\" "
      "\"float raduis\" 2 \"string colour\" \"red\"\n                 ^");
  CHECK(loaded.warnings[1].message == "\"string colour\" is not known here, and left out");
}

TEST_CASE("included files are read in place, and imported ones keep their state to themselves") {
  const test::PbrtTexts files{{"part.pbrt", "Translate 1 0 0\n"}};
  const auto x_of = [&](const std::string& statement) {
    return load_pbrt_world(statement + " \"part.pbrt\"\n" + pbrt_triangle, files)
        .scene.geometry->bounds()
        .lower.x;
  };
  CHECK(x_of("Include") == 1);
  CHECK(x_of("Import") == 0);
}

TEST_CASE("files that include themselves, or lie too deep, or are missing, are errors") {
  CHECK(error_of("Include \"a\"", {{"a", "\nInclude \"b\""}, {"b", "Include \"a\""}}) ==
        "b:1:1: \"a\" includes itself, here or by way of others\n  Include \"a\"\n  ^");
  CHECK(error_of("Include \"scene.pbrt\"").starts_with("scene.pbrt:1:1: \"scene.pbrt\" includes itself"));
  CHECK(error_of("Include \"none\"").starts_with("scene.pbrt:1:1: none: there is no such file"));
  CHECK(error_of(std::string("Include \"a\0b\"", 13))
            .starts_with("scene.pbrt:1:1: the name of a file has a zero byte"));
  test::PbrtTexts deep;
  for (int i = 0; i < 40; ++i) deep[fmt::format("f{}", i)] = fmt::format("Include \"f{}\"", i + 1);
  CHECK(error_of("Include \"f0\"", deep).find("files include each other more than 30 deep") !=
        std::string::npos);
}

TEST_CASE("an object is shown where it is instanced, and nowhere else") {
  const std::string object = "ObjectBegin \"a\"\nTranslate 0 0 5\n" + pbrt_triangle + "ObjectEnd\n";
  CHECK(load_pbrt_world(object).scene.geometry->triangle_count() == 0);
  const LoadedScene twice =
      load_pbrt_world(object + "ObjectInstance \"a\"\nTranslate 7 0 0\nObjectInstance \"a\"\n");
  CHECK(twice.scene.geometry->triangle_count() == 2);
  CHECK(twice.scene.geometry->bounds().lower == Vec3{0, 0, 5});
  CHECK(twice.scene.geometry->bounds().upper == Vec3{8, 1, 5});
  CHECK(error_of("WorldBegin\n" + object + "ObjectInstance \"b\"")
            .find("no object \"b\" is defined before this; \"a\" is the nearest one") != std::string::npos);
}

TEST_CASE("an object that is shown often is stored once, but for what emits") {
  const std::string object =
      "ObjectBegin \"a\"\nTranslate 0 0 5\n" + pbrt_triangle +
      "AttributeBegin\nAreaLightSource \"diffuse\"\n" + pbrt_triangle +
      "AttributeEnd\nMaterial \"diffuse\" \"rgb reflectance\" [1 0 0]\nShape \"sphere\"\n" + "ObjectEnd\n";
  const std::string shown = "ObjectInstance \"a\"\nTranslate 7 0 0\nScale -2 2 2\nObjectInstance \"a\"\n";
  const auto load = [&](const std::string& text, InstanceUse use) {
    LoadOptions options;
    options.instances = use;
    return test::load_pbrt_text("WorldBegin\n" + pbrt_triangle + text, options);
  };
  const LoadedScene kept = load(object + shown, InstanceUse::keep),
                    copied = load(object + shown, InstanceUse::copy);
  const Geometry& geometry = *kept.scene.geometry;
  CHECK(kept.summary.instances == 2);
  CHECK(kept.summary.prototypes == 1);
  CHECK(kept.summary.repeated == 1);
  CHECK(copied.summary.repeated == 1);
  CHECK(kept.summary.seen_primitives == 7);
  CHECK(geometry.direct_shapes() == ShapeRange{0, 3});  // One beside the object, and its light twice.
  CHECK(geometry.prototypes() == std::vector<ShapeRange>{{3, 2}});
  CHECK(kept.scene.lights.size() == 2);
  // Spheres' boxes are rounded outward before and after they are scaled.
  const Aabb &bounds = geometry.bounds(), &of_copies = copied.scene.geometry->bounds();
  CHECK(max_abs(bounds.lower - of_copies.lower) < 1e-5f);
  CHECK(max_abs(bounds.upper - of_copies.upper) < 1e-5f);
  CHECK(geometry.instances()[1].to_world.point({0, 0, 5}) == Vec3{7, 0, 10});
  CHECK(kept.scene.materials[kept.scene.bindings[4].material].name ==
        copied.scene.materials[copied.scene.bindings[3].material].name);
  CHECK(asset_of(kept.scene, 3) == 0);
  CHECK(copied.scene.geometry->instances().empty());
  CHECK(copied.summary.instances == 0);
  CHECK(load(object + shown, InstanceUse::automatic).summary.instances == 0);
  // What no instance can be is copied all the same; what reaches too far is an error where it stands.
  const std::string one = "ObjectInstance \"a\"\n";
  const LoadedScene flat = load(object + one + "Scale 1 1 1e-9\n" + one, InstanceUse::keep);
  CHECK(flat.summary.instances == 1);
  CHECK(flat.scene.lights.size() == 2);
  CHECK_THROWS_WITH(load(object + one + "Translate 2e12 0 0\n" + one, InstanceUse::keep),
                    Catch::Contains("coordinate"));
}

TEST_CASE("an instance that reaches too far is an error where it stands") {
  LoadOptions keep;
  keep.instances = InstanceUse::keep;
  const std::string object =
      "WorldBegin\nObjectBegin \"a\"\nTranslate 0 0 5\n" + pbrt_triangle + "ObjectEnd\n";
  const std::string one = "ObjectInstance \"a\"\n";
  CHECK_THROWS_WITH(test::load_pbrt_text(object + one + "Translate 2e12 0 0\n" + one, keep),
                    Catch::Contains("this instance reaches to (2e+12,"));
}

TEST_CASE("only objects that are stored once are prototypes, and spheres count") {
  std::string shown;
  for (int i = 0; i < 60001; ++i) shown += "ObjectInstance \"a\"\n";
  const LoadedScene loaded =
      load_pbrt_world("ObjectBegin \"b\"\n" + pbrt_triangle + "ObjectEnd\nObjectBegin \"a\"\n" +
                      "Shape \"sphere\"\nObjectEnd\nObjectInstance \"b\"\n" + shown);
  CHECK(loaded.summary.prototypes == 1);
  CHECK(loaded.summary.instances == 60001);
  CHECK(loaded.scene.geometry->sphere_count() == 1);
  CHECK(loaded.scene.geometry->triangle_count() == 1);
}

TEST_CASE("instances are made where copies would be many") {
  CHECK_FALSE(are_stored_once(InstanceUse::automatic, 1000, 1));
  CHECK_FALSE(are_stored_once(InstanceUse::automatic, 1000, 51));
  CHECK(are_stored_once(InstanceUse::automatic, 1000, 52));
  CHECK_FALSE(are_stored_once(InstanceUse::automatic, 0, 1000));
  CHECK(are_stored_once(InstanceUse::keep, 1, 2));
  CHECK_FALSE(are_stored_once(InstanceUse::keep, 1, 1));
  CHECK_FALSE(are_stored_once(InstanceUse::copy, 1000000, 1000000));
}

TEST_CASE("the shapes of an object's instances belong to it, others to themselves") {
  const auto object = [](const std::string& name) {
    return "ObjectBegin \"" + name + "\"\n" + pbrt_triangle + pbrt_triangle + "ObjectEnd\n";
  };
  const Scene scene = load_pbrt_world(object("a") + object("b") + "ObjectInstance \"b\"\n" + pbrt_triangle +
                                      "ObjectInstance \"a\"\nObjectInstance \"a\"\n")
                          .scene;
  std::vector<std::uint32_t> assets;
  for (const ShapeBinding& binding : scene.bindings) assets.push_back(binding.asset);
  CHECK(scene.assets == std::vector<std::string>{"a", "b"});
  CHECK(assets == std::vector<std::uint32_t>{no_asset, 0, 0, 0, 0, 1, 1});
  CHECK(asset_of(scene, 0) == 2 + 0);
}

TEST_CASE("Attribute gives defaults until the state that it stands in ends") {
  const LoadedScene loaded = load_pbrt_world(
      "AttributeBegin\nAttribute \"shape\" \"float radius\" 3\nShape \"sphere\"\nShape \"sphere\" \"float "
      "radius\" 2\nAttributeEnd\nShape \"sphere\"\n");
  CHECK(loaded.warnings.empty());
  const auto radius = [&](std::uint32_t i) {
    return loaded.scene.geometry->sphere_set(i)->spheres[0].radius;
  };
  CHECK(radius(0) == 3);
  CHECK(radius(1) == 2);
  CHECK(radius(2) == 1);
}

TEST_CASE("an Attribute that none of the statements knows which it is for is named") {
  const LoadedScene loaded = load_pbrt_world(
      "Attribute \"shape\" \"float radis\" 3 \"float zmin\" -1\n"  // The sphere knows the second one,
      "Attribute \"shape\" \"integer levels\" 3\n"                 // the subdivided surface this,
      "Attribute \"light\" \"float nonsense\" 3\n"                 // and there is no light.
      "Shape \"sphere\"\n" +
      pbrt_triangle +
      "Shape \"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n"
      "Shape \"sphere\"\n");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].text().starts_with(
      "scene.pbrt:2:19: \"float radis\" is not known to what it is a default for, and left out; \"radius\" "
      "is\n"));
}

TEST_CASE("a parameter that stands in a statement twice is named, and the last one counts") {
  const LoadedScene loaded = load_pbrt_world(
      "Attribute \"shape\" \"float radius\" 5\n"
      "Shape \"sphere\" \"float radius\" 3 \"float radius\" 2\nShape \"sphere\"\n");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].text().starts_with(
      "scene.pbrt:3:33: \"radius\" stands there a second time, and counts here\n"));
  CHECK(loaded.scene.geometry->sphere_set(0)->spheres[0].radius == 2);
  CHECK(loaded.scene.geometry->sphere_set(1)->spheres[0].radius == 5);
}

TEST_CASE("reading statements takes time and memory by their number") {
  // A million: a quadratic reader would not come to its end within the test's time.
  std::string text = "WorldBegin\n";
  for (int i = 0; i < 500'000; ++i)
    text += "AttributeBegin Translate 1 0 0 Material \"diffuse\" AttributeEnd\n";
  const PbrtFiles files("a.pbrt");
  PbrtParser parser({"a.pbrt", text}, files);
  PbrtStatement statement;
  std::size_t count = 0;
  while (parser.next(statement)) ++count;
  CHECK(count == 2'000'001);
}

}  // namespace twinray
