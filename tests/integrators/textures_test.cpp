// SPDX-License-Identifier: Apache-2.0
// How wide what a path sees of a texture is. The texture's pixels are black and white by turns: seen nearer
// than they are wide they are black or white, and from level 1 of the mip-map on grey.
#include <cmath>

#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr std::uint32_t samples_of_texture = 512;

/// A square has 32 density pixels for each unit of length: it has no texture coordinates, and the weights of
/// its corners are 1/2 a unit of length.
TextureModel black_and_white(float density) {
  Image picture(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) picture.at(x, y) = (x + y) % 2 ? Rgb{1, 1, 1} : Rgb{};
  return ImageTexture{std::make_shared<const MipMap>(picture),
                      WrapMode::repeat,
                      TextureFilter::stochastic,
                      {{{density, 0, 0.3f}, {0, density, 0.3f}}}};
}

/// A floor at y = 0, seen in one point, and a wall behind it that a mirror there would show.
Scene floor_and_wall(const SurfaceModel& floor) {
  Mesh wall = floor_square(1, 0);
  for (Vec3& p : wall.positions) p = {p.x, 2 + p.z, -2};
  Scene scene = scene_of(floor_square(1, 0), {}, {0, 2, 2}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-5f;
  std::vector<Shape> shapes(scene.geometry->shapes().begin(), scene.geometry->shapes().end());
  shapes.push_back(wall);
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials = {{"floor", floor}, {"wall", Lambert{}}};
  scene.bindings.push_back({1});
  add_light(scene, PointLight{{0.3f, 2, 0.5f}, {10, 10, 10}, {}});
  return scene;
}

struct Levels {
  int grey = 0, other = 0;
};

/// How many samples of `depth` bounces see what they would if the wall were grey. The cone is the camera's.
Levels levels_of(Scene scene, float density, const RayCone& cone, int depth) {
  const PathOptions options{.max_depth = depth, .first_depth = depth};
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const Camera camera = scene.camera;
  Tracer tracer(*accelerator, false);
  const auto radiance_of = [&](std::uint32_t index) {
    const CameraSample sample{camera_ray(camera, {0.5f, 0.5f}, {}), {1, 0, 0, index}, cone};
    Rgb radiance;
    PathReference(scene, options)
        .sample({&sample, 1}, SamplerKind::sobol, tracer, RecordSpans({&radiance, 1}));
    return radiance;
  };
  std::vector<Rgb> grey;
  for (std::uint32_t i = 0; i < samples_of_texture; ++i) grey.push_back(radiance_of(i));
  scene.textures = {{"", black_and_white(density)}};
  scene.materials[1].textures = {{MaterialInput::reflectance, 0}};
  Levels found;
  for (std::uint32_t i = 0; i < samples_of_texture; ++i)
    if (!is_black(grey[i])) ++(radiance_of(i) == grey[i] ? found.grey : found.other);
  REQUIRE(found.grey + found.other > 4);
  return found;
}

/// The length of the path to the wall and the root of the cosine there.
const double to_wall = 4 * std::sqrt(2.0), slant = std::pow(0.5, 0.25);

/// The spread of a cone that sees so many pixels of the wall in the mirror.
RayCone cone_of(double pixels, double distance) { return {0, float(pixels * slant / (32 * distance))}; }

}  // namespace

TEST_CASE("a texture in a mirror is seen at the level of the whole way to it") {
  const Scene scene = floor_and_wall(Mirror{});
  // Of one pixel and less, level 0; of two to four, level 1 and 2. From the mirror alone it would be half of
  // it.
  CHECK(levels_of(scene, 1, cone_of(0.95, to_wall), 2).grey == 0);
  CHECK(levels_of(scene, 1, cone_of(2.1, to_wall), 2).other == 0);
  const Levels between = levels_of(scene, 1, cone_of(std::sqrt(2.0), to_wall), 2);
  CHECK(between.grey > int(samples_of_texture) / 4);
  CHECK(between.other > int(samples_of_texture) / 4);
  // A cone that has a width and does not widen.
  const auto width = float(slant / 32);
  CHECK(levels_of(scene, 1, {0.95f * width, 0}, 2).grey == 0);
  CHECK(levels_of(scene, 1, {2.1f * width, 0}, 2).other == 0);
}

TEST_CASE(
    "behind a surface that scatters widely a texture is seen at a coarse level, however narrow the ray") {
  const RayCone ray;
  const Levels behind_paint = levels_of(floor_and_wall(Lambert{{0.8f, 0.8f, 0.8f}}), 1, ray, 2);
  CHECK(behind_paint.other == 0);
  // A lobe of a metal is narrower: seen of a denser texture.
  const Conductor metal{.roughness = {0.2f, 0.2f}};
  CHECK(levels_of(floor_and_wall(metal), 32, ray, 2).other == 0);
  CHECK(levels_of(floor_and_wall(metal), 0.05f, ray, 2).grey < int(samples_of_texture) / 4);
  CHECK(levels_of(floor_and_wall(Mirror{}), 32, ray, 2).grey == 0);
}

}  // namespace twinray::test
