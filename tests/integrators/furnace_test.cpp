// SPDX-License-Identifier: Apache-2.0
#include "integrators/furnace.h"

#include <cmath>

#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// A ball of a material that fills the picture, beside a lamp and under a sky of its own.
Scene ball_in_furnace(const SurfaceModel& model) {
  Scene scene = scene_of({}, {}, {0, 0, 3}, {0, 0, 0});
  scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{SphereSet{"ball", {{{0, 0, 0}, 1}}}});
  scene.materials = {{"ball", model}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  add_light(scene, PointLight{{0, 3, 3}, {7, 7, 7}, {}});
  add_light(scene, AmbientLight{{0, 1, 0}, {5, 5, 5}});
  return scene;
}

Estimate furnace(const Scene& scene, int max_depth, std::uint32_t samples = 64) {
  return estimate_of(render_with(scene, FurnaceIntegrator(scene, max_depth), small_picture(samples)).film);
}

}  // namespace

TEST_CASE("in a furnace a convex Lambert shape has the radiance of its albedo, sample by sample") {
  for (const float albedo : {1.0f, 0.5f}) {
    const Estimate found = furnace(ball_in_furnace(Lambert{{albedo, albedo, albedo}}), 5);
    CHECK(found.mean == Approx(albedo).epsilon(render_rounding));
    CHECK(found.standard_error < render_rounding);
  }
}

TEST_CASE("in a furnace smooth surfaces that lose no light are not seen, once paths are long enough") {
  for (const SurfaceModel& model :
       {SurfaceModel(Mirror{}), SurfaceModel(Dielectric{}), SurfaceModel(Dielectric{.is_thin = true}),
        SurfaceModel(DiffuseTransmission{{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}})}) {
    CAPTURE(model.index());
    const Estimate found = furnace(ball_in_furnace(model), 100);
    CHECK(found.mean == Approx(1).epsilon(render_rounding));
    CHECK(found.standard_error < render_rounding);
  }
}

TEST_CASE("in a furnace a rough metal that loses nothing is white on the whole") {
  const Conductor metal{.eta = {1, 1, 1}, .k = {1e4f, 1e4f, 1e4f}, .roughness = {0.5f, 0.5f}};
  // A metal so bright reflects all but 1e-3; its compensation is a table's, within 1e-2.
  const Estimate found = furnace(ball_in_furnace(metal), 5, 4096);
  CHECK(found.mean == Approx(1).margin(0.012));
}

TEST_CASE("in a furnace several materials have the radiance that paths find under a white sky") {
  Mesh walls = inward_box(1);
  walls.triangles.resize(10);  // One side is open.
  Scene scene = scene_of(std::move(walls), {0.9f, 0.8f, 0.7f}, {0, 0, 0.9f}, {0, 0, 0});
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"glass", {{{0, 0, -0.2f}, 0.4f}}});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials.push_back({"glass", Dielectric{.roughness = {0.4f, 0.4f}}});
  scene.bindings.push_back({1});
  Scene under_sky = scene;
  Image white(1, 1);
  white.pixels[0] = {1, 1, 1};
  add_light(under_sky, EnvironmentLight{std::make_shared<const Image>(std::move(white))});
  check_same_mean(furnace(scene, 6, 4096),
                  estimate(under_sky, {.max_depth = 6, .roulette = {1}}, small_picture(4096)), 0.06);
}

TEST_CASE("in a furnace a body is darker by what it absorbs") {
  Scene scene = ball_in_furnace(Dielectric{.ior = 1});
  scene.materials[0].interior.absorption = {0.5f, 0.5f, 0.5f};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 1e-3f;
  CHECK(furnace(scene, 5).mean == Approx(std::exp(-0.5 * 2)).epsilon(1e-4));  // Pixels see shorter ways, too.
}

TEST_CASE("in a furnace light is lost that is scattered more often than the depth allows") {
  // Within a closed box no path ever leaves; a ball that only refracts is left at the second event.
  CHECK(furnace(emissive_enclosure(1, 1), 100).mean == 0);
  const Scene scene = ball_in_furnace(Refraction{});
  CHECK(furnace(scene, 1).mean == 0);
  CHECK(furnace(scene, 2).mean == Approx(1).epsilon(render_rounding));
  CHECK(furnace(ball_in_furnace(Lambert{{1, 1, 1}}), 0).mean == 0);
}

TEST_CASE("the sky of a furnace is white where there is nothing") {
  Scene scene = ball_in_furnace(Lambert{});
  scene.camera = camera_at({0, 0, 3}, {0, 0, 9});
  CHECK(furnace(scene, 0).mean == Approx(1).epsilon(render_rounding));
}

TEST_CASE("in a furnace the mean of stochastic textures is that of the pixels around") {
  // Half way between a black and a white pixel.
  Image picture(2, 1);
  picture.pixels = {{}, {1, 1, 1}};
  const ImageTexture image{std::make_shared<const MipMap>(picture),
                           WrapMode::clamp,
                           TextureFilter::stochastic,
                           {{{0, 0, 0.5f}, {0, 0, 0.5f}}}};
  Scene scene = ball_in_furnace(Lambert{});
  scene.textures = {{"", image}};
  scene.materials[0].textures = {{MaterialInput::reflectance, 0}};
  check_mean(furnace(scene, 5, 65536), 0.5, 0.02);
}

TEST_CASE("a furnace has the same bits on every engine and number of threads") {
  const Scene scene = small_room();
  check_engines(scene, FurnaceIntegrator(scene, 5));
}

}  // namespace twinray::test
