// SPDX-License-Identifier: Apache-2.0
// Light of media, and media from files and by noise: read by the pbrt reader, and written.
#include <vector>

#include "io/pbrt/cloud.h"
#include "io/pbrt/medium.h"
#include "io/scene_file.h"
#include "tests/io/nanovdb/nvdb_bytes.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/round_trip.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace twinray {
namespace {

using test::load_pbrt_world;
using test::pbrt_error;

const std::string ball = "Shape \"sphere\" ";

const Material& material_of(const LoadedScene& loaded, std::size_t shape) {
  return loaded.scene.materials[loaded.scene.bindings[shape].material];
}

/// A medium in a ball.
std::string ball_of(const std::string& type, const std::string& parameters) {
  return "MakeNamedMedium \"m\" \"string type\" \"" + type + "\" " + parameters +
         " Material \"interface\" MediumInterface \"m\" \"\" " + ball;
}

}  // namespace

TEST_CASE("light of media: pbrt's color, factors from point to point, and temperatures") {
  const auto loaded = [](const std::string& type, const std::string& parameters) {
    const LoadedScene scene = load_pbrt_world(ball_of(type, parameters));
    CHECK(scene.warnings.empty());
    return scene;
  };
  const LoadedScene even = loaded("homogeneous", "\"rgb Le\" [ 1 2 4 ] \"float Lescale\" 3");
  CHECK(material_of(even, 0).interior.glow == Glow{.radiance = {3, 6, 12}});
  CHECK_FALSE(material_of(loaded("homogeneous", "\"float Lescale\" 3"), 0).interior.emits());
  const std::string numbers = "\"integer nx\" 2 \"float density\" [ 1 2 ] ";
  const LoadedScene factors =
      loaded("uniformgrid", numbers + "\"rgb Le\" [ 1 2 4 ] \"float Lescale\" [ 5 6 ]");
  CHECK(material_of(factors, 0).interior.glow == Glow{.radiance = {1, 2, 4}, .factor = 1});
  CHECK(factors.scene.densities[1]->value(1, 0, 0) == 6);
  const LoadedScene hot =
      loaded("uniformgrid", numbers +
                                "\"float temperature\" [ 7 8 ] \"float temperaturescale\" "
                                "100 \"float temperatureoffset\" -3");
  CHECK(material_of(hot, 0).interior.glow == Glow{{1, 1, 1}, 2, 1, -3, 100});
  // Without factors pbrt has a grid of one.
  REQUIRE(hot.scene.densities.size() == 3);
  CHECK(hot.scene.densities[2]->size() == DensityGrid::Size{1, 1, 1});
  CHECK(hot.scene.densities[2]->value(0, 0, 0) == 1);
  CHECK(hot.scene.densities[2]->to_unit() == hot.scene.densities[0]->to_unit());
  CHECK(hot.scene.densities[1]->value(0, 0, 0) == 7);
  const LoadedScene older =
      loaded("uniformgrid", numbers + "\"float temperature\" [ 7 8 ] \"float temperaturecutoff\" 2");
  CHECK(material_of(older, 0).interior.glow.temperature_offset == 2);
  const auto error = [&](const std::string& parameters) {
    return pbrt_error("MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" " + numbers + parameters);
  };
  CHECK(test::contains(error("\"float temperature\" [ 7 8 ] \"rgb Le\" [ 1 1 1 ]"),
                       "either \"Le\" or \"temperature\", not both"));
  CHECK(test::contains(pbrt_error(ball_of("homogeneous", "\"rgb Le\" [ 1e20 0 0 ] \"float Lescale\" 1e30")),
                       "this medium emits more light than a number can say"));
  CHECK(test::contains(error("\"float temperature\" [ 7 ]"), "\"temperature\": a grid of 2 x 1 x 1"));
  CHECK(test::contains(error("\"float Lescale\" [ 7 -8 ]"), "\"Lescale\": a number of the grid is -8"));
}

TEST_CASE("written pbrt and exchange: light of media comes back as it was, or what is lost is named") {
  const auto interior_of = [](const Scene& scene) {
    return scene.materials[scene.bindings.at(0).material].interior;
  };
  const auto scene_with = [](const Glow& glow, std::uint32_t density) {
    Scene scene = test::scene_of(SphereSet{"ball", {{{0, 0, 0}, 1}}}, Dielectric{});
    scene.materials[0].interior = {.absorption = {1, 2, 3}, .density = density, .glow = glow};
    for (float k = 0; k < 4; ++k)
      scene.densities.push_back(std::make_shared<const DensityGrid>(
          DensityGrid::Size{2, 1, 1}, std::vector<float>{k + 1, 5}, Transform::scaling(1, 1, k < 3 ? 1 : 2)));
    check_scene(scene);
    return scene;
  };
  const Glow even_glow{.radiance = {4, 5, 6}}, factors{.radiance = {4, 5, 6}, .factor = 1},
      hot{{1, 1, 1}, 1, 2, 0.25f, 2};
  for (const Glow& glow : {factors, hot})
    for (const char* name : {"a.pbrt", "a.json"}) {
      const test::RoundTrip trip = test::round_trip(scene_with(glow, 0), name);
      CHECK(trip.warnings.empty());
      CHECK(interior_of(trip.scene).glow == glow);
      CHECK(interior_of(trip.scene).density == 0);
    }
  CHECK(interior_of(test::round_trip(scene_with(even_glow, 0), "a.json").scene).glow == even_glow);
  const Scene ones = test::round_trip(scene_with(even_glow, 0), "a.pbrt").scene;
  CHECK(interior_of(ones).glow == factors);
  CHECK(ones.densities[1]->value(0, 0, 0) == 1);
  // What pbrt has by itself is not written.
  Scene own = scene_with(factors, 0);
  own.densities[1] = std::make_shared<const DensityGrid>(DensityGrid::Size{1, 1, 1}, std::vector<float>{1},
                                                         own.densities[0]->to_unit());
  const test::RoundTrip own_trip = test::round_trip(own, "a.pbrt");
  CHECK(interior_of(own_trip.scene).glow == factors);
  CHECK(own_trip.scene.densities[1]->size() == DensityGrid::Size{1, 1, 1});
  CHECK_FALSE(test::contains(own_trip.text, "Lescale"));
  CHECK(own_trip.warnings.empty());
  const test::RoundTrip even = test::round_trip(scene_with(even_glow, no_density), "a.pbrt");
  CHECK(even.warnings.empty());
  CHECK(interior_of(even.scene).glow == even_glow);
  const auto losses = [&](const Glow& glow, std::uint32_t density) {
    return test::round_trip(scene_with(glow, density), "a.pbrt").warnings;
  };
  CHECK(losses(factors, no_density) ==
        std::vector<std::string>{"light of an even medium that is not even is written as if it were"});
  CHECK(losses({.radiance = {1, 1, 1}, .factor = 3}, 0) ==
        std::vector<std::string>{
            "where a medium emits light is left out: it does not go by the grid of its density"});
  CHECK(losses({.radiance = {2, 1, 1}, .temperature = 1}, 0) ==
        std::vector<std::string>{"the factor of a medium's temperatures is left out"});
}

TEST_CASE("a nanovdb medium has the grids of its file, in the space of its statement") {
  const test::TemporaryFolder folder;
  test::write_text(folder.file("smoke.nvdb"),
                   test::nvdb_bytes({{.name = "density", .voxels = {{{1, 2, 3}, 4}}},
                                     {.name = "temperature", .voxels = {{{1, 2, 3}, 900}}},
                                     {.name = "other", .voxels = {{{0, 0, 0}, 2}, {{0, 0, 1}, -2}}}}));
  const auto load = [&](const std::string& parameters) {
    test::write_text(folder.file("a.pbrt"), "WorldBegin Translate 10 0 0 " + ball_of("nanovdb", parameters));
    return load_scene(folder.file("a.pbrt"));
  };
  const LoadedScene loaded = load(
      "\"string filename\" \"smoke.nvdb\" \"rgb sigma_s\" [ 2 3 4 ] \"float scale\" 2 "
      "\"float Lescale\" 3 \"float temperaturescale\" 2 \"float temperatureoffset\" 5 "
      "\"float g\" 0.5");
  CHECK(loaded.warnings.empty());
  const Interior& interior = material_of(loaded, 0).interior;
  CHECK(interior == Interior{.absorption = {2, 2, 2},
                             .scattering = {4, 6, 8},
                             .anisotropy = 0.5f,
                             .density = 0,
                             .glow = {{3, 3, 3}, no_density, 1, 5, 2}});
  CHECK(loaded.scene.densities[0]->at({11, 2, 3}) == Approx(4));
  CHECK(loaded.scene.densities[1]->at({11, 2, 3}) == Approx(900));
  // pbrt's has no light of another color, and a wrong name is no darkness.
  const LoadedScene unused = load("\"string filename\" \"smoke.nvdb\" \"rgb Le\" [ 1 1 1 ]");
  REQUIRE(unused.warnings.size() == 1);
  CHECK(test::contains(unused.warnings[0].message, "Le"));
  // By names; without a grid of temperatures it is dark.
  const LoadedScene dark = load(
      "\"string filename\" \"smoke.nvdb\" \"string gridname\" \"other\" "
      "\"string temperaturename\" \"heat\"");
  REQUIRE(dark.warnings.size() == 2);
  CHECK(test::contains(dark.warnings[1].message, "has no grid \"heat\": this medium emits no light"));
  CHECK(test::contains(dark.warnings[0].message, "1 of the numbers of \"other\" in "));
  CHECK(test::contains(dark.warnings[0].message, "are below 0: 0 stands for them"));
  CHECK(dark.scene.densities.size() == 1);
  CHECK(dark.scene.densities[0]->at({10, 0, 0}) == Approx(2));
  CHECK_FALSE(material_of(dark, 0).interior.emits());
  const auto error = [&](const std::string& parameters) {
    return test::error_text([&] { load(parameters); });
  };
  CHECK(test::contains(error(""), "a nanovdb medium needs its file, \"string filename\""));
  CHECK(test::contains(error("\"string filename\" \"none.nvdb\""), "none.nvdb"));
  CHECK(test::contains(error("\"string filename\" \"a.pbrt\""), "is not a NanoVDB file"));
  CHECK(test::contains(error("\"string filename\" \"smoke.nvdb\" \"string gridname\" \"fog\""),
                       "has no grid \"fog\"; it has \"density\", \"temperature\", \"other\""));
}

TEST_CASE("a cloud is a grid of its noise, within its box") {
  const LoadedScene loaded = load_pbrt_world(
      "Scale 2 2 2 " + ball_of("cloud",
                               "\"float density\" 2 \"float wispiness\" 0.5 \"float frequency\" 1 "
                               "\"rgb sigma_a\" [ 0 0 0 ] \"rgb sigma_s\" [ 5 5 5 ] \"float g\" 0.25 "
                               "\"point3 p0\" [ 0 0 -1 ] \"point3 p1\" [ 1 1 1 ]"));
  CHECK(loaded.warnings.empty());
  CHECK(material_of(loaded, 0).interior ==
        Interior{.scattering = {5, 5, 5}, .anisotropy = 0.25f, .density = 0});
  const DensityGrid& grid = *loaded.scene.densities[0];
  CHECK(grid.size() == DensityGrid::Size{39, 39, 78});
  const PbrtCloud cloud{.density = 2, .wispiness = 0.5f, .frequency = 1};
  const Vec3 middle{10.5f / 39, 28.5f / 39, -1 + 2 * 60.5f / 78};
  CHECK(grid.at(middle * 2) == Approx(cloud.at(middle)).margin(1e-3));
  CHECK(test::contains(pbrt_error(ball_of("cloud", "\"point3 p1\" [ 1 0 1 ]")), "flat"));
}

}  // namespace twinray
