// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/light.h"

#include <cmath>
#include <fstream>

#include "core/angle.h"
#include "core/direction_map.h"
#include "io/picture/image_file.h"
#include "io/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/pbrt_text.h"
#include "tests/support/temporary_folder.h"

namespace twinray {
namespace {

using test::load_pbrt_text;
using test::load_pbrt_world;
using test::pbrt_triangle;

template <typename Source>
Source light_of(const std::string& statements) {
  const LoadedScene loaded = load_pbrt_world(statements);
  REQUIRE(loaded.scene.lights.size() == 1);
  return std::get<Source>(loaded.scene.lights[0].source);
}

}  // namespace

TEST_CASE("an area light emits from the outside of its shape, or from both sides") {
  const auto triangle = [](const std::string& more) {
    return light_of<MeshLight>("AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ] \"float scale\" 2 " + more +
                               "\n" + pbrt_triangle);
  };
  CHECK(triangle("").radiance == Rgb{2, 4, 6});
  CHECK(triangle("").side == EmissionSide::front);
  CHECK(triangle("\"bool twosided\" true").side == EmissionSide::both);
  CHECK(light_of<SphereLight>("AreaLightSource \"diffuse\" Shape \"sphere\"").radiance == Rgb{1, 1, 1});
}

TEST_CASE("an area light of a power has it, over the area and both sides") {
  const std::string light = "AreaLightSource \"diffuse\" \"float power\" 100 ";
  CHECK(light_of<MeshLight>(light + pbrt_triangle).radiance.g == Approx(100 / (pi_double * 0.5)));
  CHECK(light_of<MeshLight>(light + "\"bool twosided\" true " + pbrt_triangle).radiance.g ==
        Approx(100 / pi_double));
  CHECK(light_of<SphereLight>(light + "Shape \"sphere\" \"float radius\" 2").radiance.g ==
        Approx(100 / (pi_double * 16 * pi_double)));
}

TEST_CASE("an area light's power is that of each triangle and of each patch, as in pbrt") {
  const std::string light = "AreaLightSource \"diffuse\" \"float power\" 100 ";
  const std::string quad = " \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ] ";
  CHECK(light_of<MeshLight>(light + "Shape \"trianglemesh\"" + quad + "\"integer indices\" [ 0 1 3 0 3 2 ]")
            .radiance.g == Approx(100 / (pi_double * 0.5)));
  CHECK(light_of<MeshLight>(light + "Shape \"bilinearmesh\"" + quad).radiance.g == Approx(100 / pi_double));
  CHECK(light_of<MeshLight>(light + "Shape \"disk\"").radiance.g ==
        Approx(100 / (pi_double * pi_double)).epsilon(1e-3));
  // What has no area is none of them.
  CHECK(light_of<MeshLight>(light + "Shape \"trianglemesh\"" + quad +
                            "\"integer indices\" [ 0 1 3  1 1 1  0 3 2 ]")
            .radiance.g == Approx(100 / (pi_double * 0.5)));
}

TEST_CASE("an area light's power is that of each face of a PLY file, of four corners, too") {
  const test::TemporaryFolder folder;
  const auto radiance = [&](const std::string& faces, int count) {
    test::write_text(
        folder.file("a.ply"),
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face " +
            std::to_string(count) +
            "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces);
    test::write_text(folder.file("a.pbrt"),
                     "WorldBegin AreaLightSource \"diffuse\" \"float power\" 100 Shape \"plymesh\" \"string "
                     "filename\" \"a.ply\"\n");
    return std::get<MeshLight>(load_scene(folder.file("a.pbrt"), {}).scene.lights.at(0).source).radiance.g;
  };
  CHECK(radiance("4 0 1 2 3\n", 1) == Approx(100 / pi_double));
  CHECK(radiance("3 0 1 2\n3 0 2 3\n", 2) == Approx(100 / (pi_double * 0.5)));
  CHECK(radiance("4 0 1 2 3\n3 0 1 2\n3 1 1 2\n", 3) == Approx(100 / (pi_double * 0.75)));
  CHECK(radiance("4 0 1 2 2\n", 1) == Approx(100 / (pi_double * 0.5)));
}

TEST_CASE("a projector needs a picture, and shines ahead alone where its file is missing") {
  CHECK_THROWS_WITH(load_pbrt_world("LightSource \"projection\""),
                    Catch::Contains("a projection light needs its picture, \"string filename\""));
  const test::TemporaryFolder folder;
  test::write_text(folder.file("a.pbrt"),
                   "WorldBegin Shape \"sphere\" LightSource \"projection\" \"string filename\" \"none.png\" "
                   "\"float scale\" 5\n");
  const LoadedScene loaded = load_scene(folder.file("a.pbrt"), {});
  CHECK(loaded.warnings.size() == 1);
  const auto& projector = std::get<ProjectionLight>(loaded.scene.lights.at(0).source);
  CHECK(projector.picture->pixels == std::vector<Rgb>{white});
  CHECK(projector.intensity == Rgb{5, 5, 5});
  const LoadedScene even = load_pbrt_world("LightSource \"goniometric\"");
  REQUIRE(even.warnings.size() == 1);
  CHECK(even.warnings[0].message ==
        "this goniometric light names no picture; it shines alike in all directions");
}

TEST_CASE("an area light's picture is times its scale, and has its power over the mean") {
  const test::TemporaryFolder folder;
  Image image(2, 1);
  image.pixels = {{0.5f, 1, 0.25f}, {}};
  write_exr(folder.file("glow.exr"), image);
  const auto load = [&](const std::string& more, const std::string& shape) {
    std::ofstream(folder.file("a.pbrt")) << "WorldBegin AreaLightSource \"diffuse\" \"string filename\" "
                                            "\"glow.exr\" "
                                         << more << "\n" + shape;
    return load_scene(folder.file("a.pbrt"), {});
  };
  const auto light = [&](const std::string& more, const std::string& shape) {
    const LoadedScene loaded = load(more, shape);
    REQUIRE(loaded.warnings.empty());
    return std::get<MeshLight>(loaded.scene.lights.at(0).source);
  };
  const MeshLight plain = light("\"float scale\" 3", pbrt_triangle);
  CHECK(plain.radiance == Rgb{3, 3, 3});
  CHECK(plain.picture->pixels == std::vector<Rgb>{{0.5f, 1, 0.25f}, {}});
  const double mean = double(luminance(Rgb{0.25f, 0.5f, 0.125f}));
  CHECK(light("\"float power\" 100 \"bool twosided\" true", pbrt_triangle).radiance.g ==
        Approx(100 / (pi_double * mean)));
  // A sphere emits by its texture coordinates: it is a mesh that has them. So has a mesh without.
  CHECK(light("", "Shape \"sphere\"").side == EmissionSide::front);
  CHECK(load("", pbrt_triangle).scene.geometry->mesh(0)->uvs.size() == 3);
  CHECK_THROWS_WITH(load("\"rgb L\" [ 1 1 1 ]", pbrt_triangle),
                    Catch::Contains("an area light has a color \"L\" or a picture \"filename\", not both"));
}

TEST_CASE("an infinite light has a color or a picture") {
  CHECK_THROWS_WITH(
      load_pbrt_world("LightSource \"infinite\" \"rgb L\" [ 7 7 7 ] \"string filename\" \"a.exr\"\n"),
      Catch::Contains("an infinite light has a color \"L\" or a picture \"filename\", not both"));
}

TEST_CASE("an area light ends with the state that it stands in") {
  const LoadedScene loaded =
      load_pbrt_world("AttributeBegin AreaLightSource \"diffuse\" AttributeEnd " + pbrt_triangle);
  CHECK(loaded.scene.lights.empty());
}

TEST_CASE("point, spot and distant lights stand where the transform puts them") {
  const auto point = light_of<PointLight>(
      "Translate 1 0 0 LightSource \"point\" \"point3 from\" [ 0 2 0 ] \"rgb I\" [ 1 2 3 ] \"float power\" "
      "10");
  CHECK(point.position == Vec3{1, 2, 0});
  CHECK(point.intensity.b == Approx(3 * 10 / (4 * pi_double)));
  const auto distant = light_of<DirectionalLight>(
      "Rotate 90 0 0 1 LightSource \"distant\" \"point3 from\" [ 0 0 0 ] \"point3 to\" [ 2 0 0 ] \"rgb L\" [ "
      "1 1 1 ]"
      " \"float illuminance\" 5");
  CHECK(distant.direction.y == Approx(1));
  CHECK(distant.irradiance.r == Approx(5));
}

TEST_CASE("light of a black body has the luminance of its scale") {
  const auto light = light_of<PointLight>("LightSource \"point\" \"blackbody I\" 3000 \"float scale\" 7");
  CHECK(luminance(light.intensity) == Approx(7).epsilon(1e-3));
  CHECK(light.intensity.r > 2 * light.intensity.b);
}

TEST_CASE("what a picture that emits has below 0 is named, and is 0") {
  const test::TemporaryFolder folder;
  Image image(2, 2, {1, 1, 1});
  image.pixels[3] = {-1, 2, 3};
  write_exr(folder.file("glow.exr"), image);
  std::ofstream(folder.file("a.pbrt")) << "WorldBegin AreaLightSource \"diffuse\" \"string filename\" "
                                          "\"glow.exr\" " +
                                              pbrt_triangle;
  const LoadedScene loaded = load_scene(folder.file("a.pbrt"));
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].text().find(
            "1 of the picture's 4 pixels are below 0 in a channel, which emits nothing") !=
        std::string::npos);
  CHECK(std::get<MeshLight>(loaded.scene.lights[0].source).picture->pixels[3] == Rgb{0, 2, 3});
}

TEST_CASE("the exposure of film and shutter multiplies all light") {
  const LoadedScene loaded = load_pbrt_text(
      "Camera \"perspective\" \"float shutterclose\" 0.5 Film \"rgb\" \"float iso\" 400 WorldBegin "
      "LightSource "
      "\"point\" AreaLightSource \"diffuse\" " +
      pbrt_triangle);
  CHECK(std::get<MeshLight>(loaded.scene.lights[0].source).radiance == Rgb{2, 2, 2});
  CHECK(std::get<PointLight>(loaded.scene.lights[1].source).intensity == Rgb{2, 2, 2});
  CHECK(loaded.summary.notes.back() ==
        "all light of the file is times 2, the film's exposure (shutter x iso / 100)");
}

TEST_CASE("the exposure of film and shutter multiplies the light of media, within shapes and around all") {
  const auto medium = [](const std::string& name) {
    return "MakeNamedMedium \"" + name + "\" \"string type\" \"homogeneous\" \"rgb Le\" [ 3 4 5 ] ";
  };
  const LoadedScene loaded = load_pbrt_text(
      medium("fog") + medium("fire") +
      "MediumInterface \"\" \"fog\" Camera \"perspective\" Film \"rgb\" \"float iso\" 200 WorldBegin "
      "MediumInterface \"fire\" \"fog\" Material \"interface\" Shape \"sphere\"");
  int media = 0;
  for (const Material& material : loaded.scene.materials) {
    if (is_black(material.interior.absorption)) continue;
    CHECK(material.interior.glow.radiance == Rgb{6, 8, 10});
    ++media;
  }
  CHECK(media == 2);
}

TEST_CASE("a shutter that stays open for longer than any exposure is an error") {
  CHECK_THROWS_WITH(load_pbrt_text("Camera \"perspective\" \"float shutterclose\" 1e38 WorldBegin"),
                    Catch::Contains("\"shutterclose\" is 1e+38; it must lie in"));
}

TEST_CASE("a picture of latitude and longitude lies as in pbrt-v3, +z above, from +x towards +y") {
  const test::TemporaryFolder folder;
  write_exr(folder.file("sky.exr"), Image(4, 2, {1, 1, 1}));
  const auto point_of = [&](const std::string& type, const Vec3& direction) {
    std::ofstream(folder.file("a.pbrt"))
        << "WorldBegin LightSource \"" + type + "\" \"string filename\" \"sky.exr\"\n" + pbrt_triangle;
    const LoadedScene loaded = load_scene(folder.file("a.pbrt"), {});
    REQUIRE(loaded.warnings.empty());
    const LightSource& light = loaded.scene.lights.at(0).source;
    const auto* environment = std::get_if<EnvironmentLight>(&light);
    const Transform rotation =
        environment ? environment->rotation : std::get<GoniometricLight>(light).rotation;
    CHECK(rotation.determinant() == Approx(environment ? 1 : -1));
    return map_point(MapLayout::latitude_longitude, rotation.inverse().vector(direction));
  };
  for (const auto& [x, y, z] : {Vec3{0.5f, 0.25f, 1}, {-1, 0.5f, 0.3f}, {-0.2f, -0.7f, -1}, {3, -1, 0}}) {
    const double turns = std::atan2(y, x) / (2 * pi_double), length = std::sqrt(x * x + y * y + z * z);
    const MapPoint sky = point_of("infinite", {x, y, z}), lamp = point_of("goniometric", {x, z, y});
    CHECK(sky.x == Approx(turns < 0 ? turns + 1 : turns));
    CHECK(sky.y == Approx(std::acos(double(z) / length) / pi_double));
    CHECK(lamp.x == Approx(sky.x));
    CHECK(lamp.y == Approx(sky.y));
  }
}

}  // namespace twinray
