// SPDX-License-Identifier: Apache-2.0
// What is kept of samples besides their radiance.
#include "core/record.h"

#include "core/error.h"
#include "integrators/normals.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr int width = 16, height = 12;

/// A coloured ball before the sky.
Scene ball() { return scene_of(icosphere(2), {0.8f, 0.4f, 0.2f}, {0, 0, 4}, {0, 0, 0}); }

RenderOptions with_layers(std::vector<Layer> layers) {
  return {.width = width, .height = height, .samples = 4, .layers = std::move(layers), .threads = 2};
}

}  // namespace

TEST_CASE("a render keeps the layers that are asked for, and its color has the bits that it has alone") {
  const Scene scene = small_room();
  for (const int depth : {0, 3}) {
    const PathIntegrator path(scene, {.max_depth = depth});
    const Film alone = render_with(scene, path, with_layers({Layer::color})).film;
    const Film film =
        render_with(scene, path, with_layers({Layer::color, Layer::normal, Layer::albedo})).film;
    CHECK(film.layers() == std::vector<std::string>{"color", "normal", "albedo"});
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        CHECK(film.pixel(0, x, y) == alone.pixel(0, x, y));
        CHECK(length(Vec3{film.pixel(1, x, y).mean().r, film.pixel(1, x, y).mean().g,
                          film.pixel(1, x, y).mean().b}) > 0.5f);
        CHECK_FALSE(is_black(film.pixel(2, x, y).mean()));
      }
  }
}

TEST_CASE("albedo and normal are those of the surface that is hit first, on the viewer's side") {
  const Scene scene = ball();
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  const PathReference reference(scene, {.max_depth = 0});
  const PathIntegrator waves(scene, {.max_depth = 0});
  for (const Integrator* const path :
       {static_cast<const Integrator*>(&reference), static_cast<const Integrator*>(&waves)}) {
    const CameraSample samples[] = {{{.origin = {0, 0, 4}, .direction = {0.1f, 0.2f, -4}}, {}},
                                    {{.origin = {0, 0, 4}, .direction = {0, 0, 1}}, {}},
                                    {{.origin = {0, 0, 0}, .direction = {1, 0.2f, 0.1f}}, {}}};
    Records records(std::vector{Layer::color, Layer::albedo, Layer::normal}, 3);
    Tracer tracer(*engine, false);
    for (const Layer layer : {Layer::albedo, Layer::normal})
      std::ranges::fill(records.spans(3)[layer], Rgb{9, 9, 9});
    path->sample(samples, SamplerKind::sobol, tracer, records.spans(3));
    const auto albedo = records.spans(3)[Layer::albedo], normal = records.spans(3)[Layer::normal];
    CHECK(albedo[0] == Rgb{0.8f, 0.4f, 0.2f});
    CHECK(albedo[1] == Rgb{});
    CHECK(albedo[2] == albedo[0]);
    CHECK(normal[0].b > 0.9f);
    CHECK(normal[1] == Rgb{});
    CHECK(normal[2].r < -0.5f);  // Seen from within.
    CHECK(tracer.counts().total() == 3);
  }
}

TEST_CASE("an integrator that knows nothing of a layer leaves it black") {
  const Scene scene = ball();
  const Film film =
      render_with(scene, NormalsIntegrator(scene), with_layers({Layer::color, Layer::albedo})).film;
  CHECK_FALSE(is_black(film.pixel(0, width / 2, height / 2).mean()));
  CHECK(is_black(film.pixel(1, width / 2, height / 2).mean()));
  CHECK(film.pixel(1, width / 2, height / 2).count == 4);
}

TEST_CASE("the layers of a render begin with color, and none comes twice") {
  const Scene scene = ball();
  for (const std::vector<Layer>& layers :
       {std::vector<Layer>{}, {Layer::albedo, Layer::color}, {Layer::color, Layer::normal, Layer::normal}})
    CHECK_THROWS_AS(render_with(scene, NormalsIntegrator(scene), with_layers(layers)), Error);
}

}  // namespace twinray::test
