// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/emitted_picture.h"

#include "tests/support/catch.h"
#include "tests/support/round_trip.h"

namespace twinray::test {
namespace {

const Rgb white{1, 1, 1};

MeshLight lamp_of_halves() {
  auto halves = std::make_shared<Image>(2, 1);
  halves->pixels = {white, {}};
  return {.radiance = white, .picture = halves};
}

const std::vector<Vec2> within{{0, 0}, {1, 0}, {1, 1}}, beside{{0, 0}, {2, 0}, {1, 1}};

}  // namespace

TEST_CASE("a picture that emits as pbrt has it is itself") {
  MeshLight lamp = lamp_of_halves();
  CHECK(emitted_picture(lamp) == lamp.picture);
  CHECK(is_emitted_whole(lamp, within));
  CHECK(is_emitted_whole(lamp, beside));
  lamp.wrap = WrapMode::repeat;
  CHECK(is_emitted_whole(lamp, within));
  CHECK_FALSE(is_emitted_whole(lamp, beside));
}

TEST_CASE("one that is moved by whole pixels, or repeated, keeps its pixels over the unit square") {
  MeshLight lamp = lamp_of_halves();
  lamp.wrap = WrapMode::repeat;
  lamp.uv = {{{1, 0, 0.5f}, {0, 1, 0}}};
  CHECK(emitted_picture(lamp)->pixels == std::vector<Rgb>{{}, white});
  lamp.uv = {{{2, 0, 0}, {0, 1, 0}}};
  CHECK(emitted_picture(lamp)->pixels == std::vector<Rgb>{white, {}, white, {}});
  lamp.wrap = WrapMode::clamp;
  CHECK(emitted_picture(lamp)->pixels == std::vector<Rgb>{white, {}, {}, {}});
  CHECK_FALSE(is_emitted_whole(lamp, beside));
}

TEST_CASE("written pbrt: a picture that emits is drawn where it lies, and what ends is told") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = mesh.uv_indices = {{0, 1, 2}};
  mesh.uvs = within;
  const auto written = [&] {
    Scene scene;
    scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{mesh});
    scene.materials = {{"m", Lambert{}}};
    MeshLight lamp = lamp_of_halves();
    lamp.wrap = WrapMode::repeat, lamp.uv = {{{2, 0, 0}, {0, 1, 0}}};
    scene.lights = {{"lamp", lamp}};
    scene.bindings = {{.material = 0, .light = 0}};
    return round_trip(scene, "a.pbrt");
  };
  const RoundTrip trip = written();
  CHECK(trip.warnings.empty());
  CHECK(std::get<MeshLight>(trip.scene.lights[0].source).picture->pixels ==
        std::vector<Rgb>{white, {}, white, {}});
  mesh.uvs = beside;
  CHECK(written().warnings ==
        std::vector<std::string>{"a picture that emits ends with the unit square of the texture coordinates, "
                                 "and goes on as at its edge"});
}

TEST_CASE("one that is turned, or of texels, is drawn as it is looked up") {
  MeshLight lamp = lamp_of_halves();
  lamp.uv = {{{0, 1, 0}, {1, 0, 0}}};
  const Image turned = *emitted_picture(lamp);
  for (const Vec2 uv : {Vec2{0.2f, 0.1f}, {0.7f, 0.5f}, {0.3f, 0.9f}})
    CHECK(bilinear(turned, WrapMode::clamp, uv).r ==
          Approx(bilinear(*lamp.picture, WrapMode::clamp, {uv.y, uv.x}).r).margin(0.01));
  lamp = lamp_of_halves();
  lamp.filter = TextureFilter::nearest;
  const Image sharp = *emitted_picture(lamp);
  CHECK(bilinear(sharp, WrapMode::clamp, {0.49f, 0.5f}) == white);
  CHECK(bilinear(sharp, WrapMode::clamp, {0.51f, 0.5f}) == Rgb{});
}

}  // namespace twinray::test
