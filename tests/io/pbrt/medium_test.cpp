// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray {
namespace {

using test::load_pbrt_world;
using test::pbrt_error;

const std::string ball = "Shape \"sphere\" ";
const std::string tea =
    "MakeNamedMedium \"tea\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 1 2 4 ] \"rgb sigma_s\" [ 0 0 "
    "0 ] ";

const Material& material_of(const LoadedScene& loaded, std::size_t shape) {
  return loaded.scene.materials[loaded.scene.bindings[shape].material];
}

std::vector<std::string> warnings_of(const std::string& statements) {
  std::vector<std::string> messages;
  for (const Diagnostic& warning : load_pbrt_world(statements).warnings) messages.push_back(warning.message);
  return messages;
}

}  // namespace

TEST_CASE("what light is absorbed by within a shape becomes its material's interior") {
  const LoadedScene loaded = load_pbrt_world(
      tea + "Material \"dielectric\" " + ball + "MediumInterface \"tea\" \"\" " + ball + ball +
      "MakeNamedMedium \"more\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 1 2 4 ] \"rgb sigma_s\" "
      "[ 0 0 0 ] \"float scale\" 0.5 MediumInterface \"more\" \"\" " +
      ball + "Material \"diffuse\" " + ball + "Material \"interface\" " + ball +
      "MediumInterface \"\" \"\" " + ball);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.bindings.size() == 6);  // The last one is no surface, and has nothing within.
  CHECK_FALSE(has_interior(material_of(loaded, 0)));
  CHECK(material_of(loaded, 1).interior.absorption == Rgb{1, 2, 4});
  CHECK(loaded.scene.bindings[1].material == loaded.scene.bindings[2].material);
  CHECK(std::holds_alternative<Dielectric>(material_of(loaded, 1).model));
  CHECK(material_of(loaded, 3).interior.absorption == Rgb{0.5f, 1, 2});
  CHECK_FALSE(has_interior(material_of(loaded, 4)));
  CHECK(std::holds_alternative<Interface>(material_of(loaded, 5).model));
  CHECK(material_of(loaded, 5).interior.absorption == Rgb{0.5f, 1, 2});
}

TEST_CASE("interfaces stand behind all other shapes, so that they hide none in the same place") {
  const std::string fog = "Material \"interface\" MediumInterface \"tea\" \"\" " + ball,
                    wall = "Material \"diffuse\" MediumInterface \"\" \"\" " + ball;
  const auto is_fog = [](const LoadedScene& loaded, std::size_t shape) {
    return std::holds_alternative<Interface>(material_of(loaded, shape).model);
  };
  const std::string object = "ObjectBegin \"o\" " + fog + wall + "ObjectEnd ";
  for (const std::string& statements : {fog + wall, object + "ObjectInstance \"o\" "}) {
    const LoadedScene loaded = load_pbrt_world(tea + statements);
    REQUIRE(loaded.scene.bindings.size() == 2);
    CHECK_FALSE(is_fog(loaded, 0));
    CHECK(is_fog(loaded, 1));
  }
}

TEST_CASE("a medium that says nothing has pbrt's numbers, and attributes end") {
  const LoadedScene loaded = load_pbrt_world(
      "Material \"dielectric\" AttributeBegin Attribute \"medium\" \"rgb sigma_s\" [ 0 0 0 ] "
      "MakeNamedMedium \"milk\" \"string type\" \"homogeneous\" MediumInterface \"milk\" \"\" " +
      ball + "AttributeEnd " + ball);
  CHECK(loaded.warnings.empty());
  CHECK(material_of(loaded, 0).interior == Interior{.absorption = {1, 1, 1}});
  CHECK_FALSE(has_interior(material_of(loaded, 1)));
}

TEST_CASE("a medium that is named outside of the camera is the atmosphere, though it is made later") {
  const std::string made_later = std::string(tea).replace(tea.find("tea"), 3, "air");
  const auto loaded = [&](const std::string& inside_outside) {
    return test::load_pbrt_text(tea + "MediumInterface " + inside_outside +
                                " Camera \"perspective\" WorldBegin MediumInterface \"\" \"\" " + made_later +
                                ball);
  };
  CHECK(loaded("\"tea\" \"\"").scene.atmosphere == no_material);
  for (const char* outside : {"\"\" \"tea\"", "\"tea\"", "\"\" \"air\""}) {
    const LoadedScene found = loaded(outside);
    CHECK(found.warnings.empty());
    REQUIRE(found.scene.atmosphere < found.scene.materials.size());
    const Material& air = found.scene.materials[found.scene.atmosphere];
    CHECK(std::holds_alternative<Interface>(air.model));
    CHECK(air.interior == Interior{{1, 2, 4}});
  }
}

TEST_CASE("what pbrt's shapes around the camera have outside is the atmosphere") {
  const std::string media =
      tea + std::string(tea).replace(tea.find("tea"), 3, "air").replace(tea.find("1 2 4"), 5, "7 7 7");
  const auto atmosphere = [&](const std::string& shapes, const char* camera = "") {
    const Scene scene = test::load_pbrt_text(media + "LookAt 0 0 5  0 0 0  0 1 0 MediumInterface \"\" \"" +
                                             camera + "\" Camera \"perspective\" WorldBegin " + shapes)
                            .scene;
    return scene.atmosphere == no_material ? Rgb{} : scene.materials[scene.atmosphere].interior.absorption;
  };
  const auto shell = [](const char* inside, const char* outside, int radius) {
    return fmt::format(
        "AttributeBegin Material \"interface\" MediumInterface \"{}\" \"{}\" Translate 0 0 5 "
        "Shape \"sphere\" \"float radius\" {} AttributeEnd ",
        inside, outside, radius);
  };
  CHECK(atmosphere(shell("tea", "air", 1)) == Rgb{7, 7, 7});
  CHECK(is_black(atmosphere(shell("tea", "", 1), "tea")));
  CHECK(atmosphere(shell("", "tea", 1) + shell("tea", "air", 2)) == Rgb{7, 7, 7});
  CHECK(atmosphere(shell("tea", "air", 2) + shell("", "tea", 1)) == Rgb{7, 7, 7});
  // Elsewhere shapes say nothing of it.
  CHECK(atmosphere("Translate 0 0 -9 " + shell("tea", "air", 1), "tea") == Rgb{1, 2, 4});
  CHECK(is_black(atmosphere("Translate 0 0 -9 " + shell("tea", "air", 1))));
}

TEST_CASE("what a medium scatters, and where to, is that of its statement or of a measured one") {
  const auto interior = [](const std::string& parameters) {
    const LoadedScene loaded =
        load_pbrt_world("MakeNamedMedium \"m\" \"string type\" \"homogeneous\" " + parameters +
                        " Material \"interface\" MediumInterface \"m\" \"\" " + ball);
    CHECK(loaded.warnings.empty());
    return material_of(loaded, 0).interior;
  };
  CHECK(interior("") == Interior{.absorption = {1, 1, 1}, .scattering = {1, 1, 1}});
  CHECK(interior("\"rgb sigma_a\" [ 0 0 0 ] \"rgb sigma_s\" [ 1 2 3 ] \"float scale\" 2 \"float g\" -0.5") ==
        Interior{.scattering = {2, 4, 6}, .anisotropy = -0.5f});
  CHECK(interior("\"float g\" 1").anisotropy == 0.99f);
  CHECK(interior("\"string preset\" \"Skin1\" \"float scale\" 10") ==
        Interior{.absorption = 10 * Rgb{0.032f, 0.17f, 0.48f}, .scattering = 10 * Rgb{0.74f, 0.88f, 1.01f}});
}

TEST_CASE("written pbrt: media that scatter and the atmosphere come back as they were") {
  Scene scene = test::scene_of(SphereSet{"ball", {{{0, 0, 0}, 1}}}, Dielectric{});
  scene.materials[0].name = "jelly";
  scene.materials[0].interior = {.absorption = {1, 2, 3}, .scattering = {4, 5, 6}, .anisotropy = 0.25f};
  scene.materials.push_back({.name = "clear", .model = Interface{}, .interior = {.is_clear = true}});
  scene.materials.push_back({.name = "plain", .model = Dielectric{}});
  scene.materials.push_back(
      {.name = "air", .model = Interface{}, .interior = {.scattering = {0.5f, 0.5f, 0.5f}}});
  scene.geometry =
      std::make_shared<const Geometry>(std::vector<Shape>(3, SphereSet{"ball", {{{0, 0, 0}, 1}}}));
  scene.bindings = {{0}, {1}, {2}};
  scene.atmosphere = 3;
  scene.densities = {std::make_shared<const DensityGrid>(
      DensityGrid::Size{3, 2, 2}, std::vector<float>{0, 1, 2, 0.1f, 4, 1.0f / 3, 6, 7, 8, 9, 10, 11},
      Transform::translation(1, 2, 3))};
  scene.materials[0].interior.density = 0;
  for (const char* name : {"a.pbrt", "a.json"}) {
    const test::RoundTrip trip = test::round_trip(scene, name);
    if (name == std::string("a.pbrt"))  // Where a ray leaves a body, pbrt asks what is outside.
      for (const char* inside : {"\"within jelly\"", "\"\"", "\"around all shapes\""})
        CHECK(test::contains(trip.text,
                             std::string("\nMediumInterface ") + inside + " \"around all shapes\"\n"));
    // An interface comes behind all others.
    std::vector<Interior> interiors;
    for (const ShapeBinding& binding : trip.scene.bindings)
      interiors.push_back(trip.scene.materials[binding.material].interior);
    REQUIRE(interiors.size() == 3);
    for (int i = 0; i < 3; ++i)
      CHECK(std::count(interiors.begin(), interiors.end(), scene.materials[std::size_t(i)].interior) == 1);
    REQUIRE(trip.scene.atmosphere < trip.scene.materials.size());
    CHECK(trip.scene.materials[trip.scene.atmosphere].interior == scene.materials[3].interior);
    REQUIRE(trip.scene.densities.size() == 1);
    const DensityGrid &read = *trip.scene.densities[0], &written = *scene.densities[0];
    REQUIRE(read.size() == written.size());
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 2; ++y)
        for (int z = 0; z < 2; ++z) CHECK(read.value(x, y, z) == written.value(x, y, z));
    CHECK(length(read.to_unit().point({5, 6, 7}) - written.to_unit().point({5, 6, 7})) < 1e-5f);
  }
}

TEST_CASE("a uniformgrid is a medium whose density lies in its box, in the space of its statement") {
  const auto grid = [](const std::string& parameters) {
    return "MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" " + parameters +
           " Identity Material \"interface\" MediumInterface \"m\" \"\" " + ball;
  };
  const std::string numbers = "\"integer nx\" 2 \"integer nz\" 2 \"float density\" [ 1 2 3 4 ] ";
  const LoadedScene loaded = load_pbrt_world(
      "Translate 1 0 0 Scale 2 2 2 " + grid(numbers + "\"point3 p0\" [ -1 0 0 ] \"point3 p1\" [ 1 1 4 ] "
                                                      "\"rgb sigma_s\" [ 3 3 3 ] \"float g\" 0.5 "));
  CHECK(loaded.warnings.empty());
  const Interior& interior = material_of(loaded, 0).interior;
  CHECK(interior ==
        Interior{.absorption = {1, 1, 1}, .scattering = {3, 3, 3}, .anisotropy = 0.5f, .density = 0});
  REQUIRE(loaded.scene.densities.size() == 1);
  const DensityGrid& read = *loaded.scene.densities[0];
  CHECK(read.size() == DensityGrid::Size{2, 1, 2});
  CHECK(read.value(1, 0, 0) == 2);
  CHECK(read.value(0, 0, 1) == 3);
  const Vec3 low = read.to_unit().point({-1, 0, 0}), high = read.to_unit().point({3, 2, 8});
  CHECK(length(low) < 1e-6f);
  CHECK(length(high - Vec3{1, 1, 1}) < 1e-6f);
  const auto error = [&](const std::string& parameters) { return pbrt_error(grid(parameters)); };
  CHECK(error("").find("a uniformgrid needs its numbers, \"float density\"") != std::string::npos);
  CHECK(error("\"integer ny\" 3 \"float density\" [ 1 2 ]").find("2 numbers; it must have 3") !=
        std::string::npos);
  CHECK(error("\"float density\" [ -1 ]").find("must be finite and >= 0") != std::string::npos);
  CHECK(error("\"integer nx\" 0 \"float density\" [ 1 ]").find("nx") != std::string::npos);
  CHECK(error(numbers + "\"point3 p1\" [ 1 0 1 ]").find("flat") != std::string::npos);
  // The box has corners in any order.
  const LoadedScene turned =
      load_pbrt_world(grid(numbers + "\"point3 p0\" [ 1 0 5 ] \"point3 p1\" [ -1 1 1 ]"));
  CHECK(turned.scene.densities[0]->to_unit().point({-1, 0, 1}) == Vec3{0, 0, 0});
  CHECK(turned.scene.densities[0]->to_unit().point({1, 1, 5}) == Vec3{1, 1, 1});
  CHECK(warnings_of(grid(numbers + "\"string preset\" \"Skin1\"")).size() == 1);
}

TEST_CASE("a grid of densities that moves is something that moves") {
  const auto is_moving = [](const std::string& transform) {
    return load_pbrt_world(transform +
                           "MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"float density\" [ 1 ] "
                           "ActiveTransform All Identity Material \"interface\" MediumInterface \"m\" \"\" " +
                           ball)
        .summary.animation.has_value();
  };
  CHECK(is_moving("ActiveTransform EndTime Translate 1 0 0 "));
  CHECK_FALSE(is_moving("Translate 1 0 0 "));
}

TEST_CASE("OpenPBR's clear surface scatters within, and loses at least what it scatters") {
  const auto interior = [](const std::string& scatter) {
    const LoadedScene loaded = load_pbrt_world(
        "Material \"openpbr\" \"float transmission_weight\" 1 \"float transmission_depth\" 2 "
        "\"rgb transmission_color\" [ 1 0.5 0.5 ] " +
        scatter + ball);
    CHECK(loaded.warnings.empty());
    return material_of(loaded, 0).interior;
  };
  const Interior some = interior(
      "\"rgb transmission_scatter\" [ 0 0.4 0 ] \"float "
      "transmission_scatter_anisotropy\" 0.3 ");
  CHECK(some.scattering == Rgb{0, 0.2f, 0});
  CHECK(some.anisotropy == 0.3f);
  CHECK(some.absorption.r == 0);
  CHECK(some.extinction().g == Approx(std::log(2.0) / 2));
  const Interior more = interior("\"rgb transmission_scatter\" [ 0.5 0.5 0.5 ] ");
  CHECK(more.absorption.r == 0);
  CHECK(more.extinction().r == Approx(0.25));
  CHECK(more.extinction().g == Approx(0.25 + std::log(2.0) / 2));
}

TEST_CASE("what has a medium outside alone is clear within, and what is turned around has it within") {
  const LoadedScene loaded = load_pbrt_world(
      tea + "Material \"dielectric\" MediumInterface \"tea\" \"\" " + ball + "MediumInterface \"\" \"tea\" " +
      ball + "Material \"interface\" " + ball + "ReverseOrientation " + ball +
      "MediumInterface \"tea\" \"\" " + ball + "MediumInterface \"\" \"\" " + ball);
  CHECK(loaded.warnings.empty());
  REQUIRE(loaded.scene.bindings.size() == 5);
  const Interior filled{{1, 2, 4}}, clear{.is_clear = true};
  const Interior expected[] = {filled, clear, clear, filled, clear};
  for (std::size_t i = 0; i < 5; ++i) CHECK(material_of(loaded, i).interior == expected[i]);
}

TEST_CASE("a shape with the same medium on both sides divides nothing, as in pbrt") {
  for (const char* media : {"\"tea\" \"tea\" ", "\"tea\" "}) {
    const LoadedScene loaded =
        load_pbrt_world(tea + "Material \"dielectric\" MediumInterface " + media + ball +
                        "ReverseOrientation " + ball + "MediumInterface \"tea\" \"\" " + ball);
    CHECK_FALSE(has_interior(material_of(loaded, 0)));
    CHECK_FALSE(has_interior(material_of(loaded, 1)));
    CHECK(material_of(loaded, 2).interior.absorption == Rgb{1, 2, 4});
  }
}

TEST_CASE("where no medium absorbs light, nothing is said to be clear") {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.pbrt"),
                    camera = "LookAt 0 0 9  0 0 0  0 1 0 Camera \"perspective\" WorldBegin ";
  const auto interior = [&](const std::string& world) {
    test::write_text(path, camera + world);
    return material_of(load_scene(path, {}), 1).interior;
  };
  const std::string inner = ball + "MediumInterface \"\" \"tea\" " + ball;
  CHECK(interior(tea + "Material \"dielectric\" MediumInterface \"tea\" \"\" " + inner).is_clear);
  CHECK_FALSE(interior(tea + "Material \"dielectric\" " + inner).is_clear);
}

TEST_CASE("written pbrt: what is clear within something that absorbs is parted from it") {
  Scene scene = test::scene_of(SphereSet{"ball", {{{0, 0, 0}, 1}}}, Dielectric{});
  scene.materials.push_back({"ice", Dielectric{}});
  scene.materials[0].interior.absorption = {0.5f, 0.25f, 0};
  scene.materials[1].interior.is_clear = true;
  scene.geometry = std::make_shared<const Geometry>(
      std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}, SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.bindings.push_back({1});
  const test::RoundTrip trip = test::round_trip(scene, "a.pbrt");
  const auto interior = [&](std::size_t shape) {
    return trip.scene.materials[trip.scene.bindings[shape].material].interior;
  };
  CHECK(interior(0) == scene.materials[0].interior);
  CHECK(interior(1) == scene.materials[1].interior);
}

TEST_CASE("a body whose metalness is a texture has an interior") {
  const LoadedScene loaded = load_pbrt_world(
      tea +
      "Texture \"none\" \"float\" \"constant\" \"float value\" 0 Material \"openpbr\" \"float "
      "transmission_weight\" 1 \"float base_metalness\" 1 \"integer priority\" 3 MediumInterface \"tea\" "
      "\"\" " +
      ball +
      "Material \"openpbr\" \"float transmission_weight\" 1 \"texture base_metalness\" \"none\" "
      "\"integer priority\" 3 " +
      ball);
  CHECK_FALSE(has_interior(material_of(loaded, 0)));
  CHECK(material_of(loaded, 1).interior.absorption == Rgb{1, 2, 4});
  CHECK(material_of(loaded, 1).interior.priority == 3);
}

TEST_CASE("nested bodies have priorities") {
  const LoadedScene loaded =
      load_pbrt_world(tea + "MediumInterface \"tea\" \"\" Material \"dielectric\" \"integer priority\" 3 " +
                      ball + "Material \"diffuse\" \"integer priority\" 3 " + ball);
  CHECK(material_of(loaded, 0).interior == Interior{{1, 2, 4}, 3});
  CHECK(material_of(loaded, 1).interior == Interior{});
  REQUIRE(loaded.warnings.size() == 1);  // A diffuse surface has none.
  CHECK(pbrt_error("Material \"dielectric\" \"integer priority\" -1").find("priority") != std::string::npos);
}

TEST_CASE("a medium within a surface that has no inside is named") {
  const std::string glass = "\"string type\" \"dielectric\" ";
  const std::string mix = "MakeNamedMaterial \"a\" " + glass + "MakeNamedMaterial \"b\" " + glass +
                          "Material \"mix\" \"string materials\" [ \"a\" \"b\" ] ";
  for (const std::string& material :
       {mix,
        std::string(
            "Material \"openpbr\" \"float transmission_weight\" 1 \"bool geometry_thin_walled\" true "),
        std::string("Material \"thindielectric\" "), std::string("Material \"diffusetransmission\" ")}) {
    const LoadedScene loaded =
        load_pbrt_world(tea + "MediumInterface \"tea\" \"\" " + material + ball + ball);
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].message ==
          "a medium is rendered within a dielectric, an interface or a clear openpbr alone, not here");
    CHECK(loaded.warnings[0].count == 2);
  }
  CHECK(load_pbrt_world(tea + "MediumInterface \"tea\" \"\" Material \"diffuse\" " + ball).warnings.empty());
}

TEST_CASE("a medium may be made behind the statement that names it") {
  const std::string shape = "MediumInterface \"tea\" \"\" Material \"dielectric\" " + ball;
  const auto absorption = [](const std::string& statements) {
    const LoadedScene loaded = load_pbrt_world(statements);
    CHECK(loaded.warnings.empty());
    return loaded.scene.materials.at(loaded.scene.bindings.at(0).material).interior.absorption;
  };
  CHECK(absorption(shape + tea) == absorption(tea + shape));
  CHECK_FALSE(is_black(absorption(shape + tea)));
}

TEST_CASE("what of media is not rendered is said, and what is none is an error") {
  const std::string begin = "MakeNamedMedium \"m\" \"string type\" ";
  CHECK(warnings_of(begin + "\"rgbgrid\"") ==
        std::vector<std::string>{"a medium of the kind \"rgbgrid\" is not rendered: it is clear"});
  CHECK(warnings_of(begin + "\"homogeneous\" \"string preset\" \"Skim\"") ==
        std::vector<std::string>{"there is no measured medium \"Skim\": its coefficients are those of the "
                                 "statement; \"Skin1\" is the nearest name"});
  CHECK(pbrt_error(begin + "\"fog\"").find("there is no medium \"fog\"; valid are homogeneous") !=
        std::string::npos);
  CHECK(pbrt_error("MakeNamedMedium \"m\"").find("\"string type\"") != std::string::npos);
  CHECK(pbrt_error(tea + tea).find("the medium \"tea\" is made a second time") != std::string::npos);
  CHECK(pbrt_error(tea + "MediumInterface \"tee\" \"\"").find("\"tea\" is the nearest one") !=
        std::string::npos);
  CHECK(pbrt_error(tea + "MediumInterface \"\" \"te\"").find("makes \"te\"") != std::string::npos);
  CHECK(pbrt_error(begin + "\"homogeneous\" \"rgb sigma_a\" [ 1 -1 1 ]").find("sigma_a") !=
        std::string::npos);
}

}  // namespace twinray
