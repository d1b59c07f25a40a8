// SPDX-License-Identifier: Apache-2.0
// What is kept of samples besides their radiance.
#include "core/record.h"

#include "check/difference.h"
#include "core/error.h"
#include "integrators/layer_records.h"
#include "integrators/normals.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr int record_width = 16, record_height = 12;
/// Points are kept off the edges of triangles by a little (core/surface.h).
constexpr double off_edges = 1e-4;

/// A coloured ball before the sky.
Scene ball_and_sky() { return scene_of(icosphere(2), {0.8f, 0.4f, 0.2f}, {0, 0, 4}, {0, 0, 0}); }

RenderOptions with_layers(std::vector<Layer> layers) {
  return {.width = record_width,
          .height = record_height,
          .samples = 4,
          .layers = std::move(layers),
          .threads = 2};
}

/// The records of these camera rays by each of the two path tracers.
std::vector<Records> records_of(const Scene& scene, const PathOptions& options,
                                std::span<const CameraSample> samples) {
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  const PathReference reference(scene, options);
  const PathIntegrator waves(scene, options);
  std::vector<Records> all;
  for (const Integrator* const path :
       {static_cast<const Integrator*>(&reference), static_cast<const Integrator*>(&waves)}) {
    Tracer tracer(*engine, false);
    Records& records = all.emplace_back(FilmContents{all_layers()}, samples.size());
    for (const Layer layer : all_layers())
      std::ranges::fill(records.spans(samples.size())[layer], Rgb{9, 9, 9});
    path->sample(samples, SamplerKind::sobol, tracer, records.spans(samples.size()));
  }
  return all;
}

/// A mirror on the floor, of this colour, with a wall behind it that a ray down to it sees.
Scene mirror_before_wall(const SurfaceModel& model) {
  Scene scene = scene_of(floor_square(1, 0), {}, {0, 2, 2}, {0, 0, 0});
  scene.materials = {{"mirror", model}, {"wall", Lambert{{0.4f, 0.6f, 0.8f}}}};
  std::vector<Shape> shapes = scene.geometry->shapes();
  Mesh wall;
  wall.positions = {{-9, -9, -3}, {9, -9, -3}, {0, 18, -3}};
  wall.triangles = {{0, 1, 2}};
  shapes.push_back(std::move(wall));
  scene.bindings = {{0}, {1}};
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  return scene;
}

/// From above the mirror down to its middle, so that the reflection goes on to the wall.
const CameraSample towards_mirror{{.origin = {0, 2, 2}, .direction = {0, -2, -2}}, {}};

}  // namespace

TEST_CASE("a render keeps the layers asked for, and its colours have the bits that they have alone") {
  const Scene scene = small_room();
  for (const int depth : {0, 3}) {
    const PathIntegrator path(scene, {.max_depth = depth});
    const Film alone = render_with(scene, path, with_layers({})).film;
    const Film film = render_with(scene, path, with_layers({Layer::normal, Layer::albedo})).film;
    CHECK(film.layers() == std::vector{Layer::normal, Layer::albedo});
    for (int y = 0; y < record_height; ++y)
      for (int x = 0; x < record_width; ++x) {
        CHECK(film.pixel(x, y) == alone.pixel(x, y));
        const Rgb normal = film.value(0, x, y);
        CHECK(length(Vec3{normal.r, normal.g, normal.b}) > 0.5f);
        CHECK_FALSE(is_black(film.value(1, x, y)));
        CHECK(film.value(1, x, y).r <= 1);
      }
  }
}

TEST_CASE("layers have the same bits by any engine, path tracer, number of threads and part of the frame") {
  const Scene scene = small_room();
  const PathReference reference(scene, {.max_depth = 3});
  const PathIntegrator waves(scene, {.max_depth = 3});
  RenderOptions options = with_layers(all_layers());
  options.light_paths = true;
  const Film film = render_with(scene, waves, options).film;
  CHECK(same_bits(film, render_with(scene, reference, options).film));
  CHECK(same_bits(film, render_with(scene, waves, options, Backend::brute_force).film));
  options.threads = 1;
  CHECK(same_bits(film, render_with(scene, waves, options).film));
  options.window = PixelRect{3, 2, 11, 9};
  const Film part = render_with(scene, waves, options).film;
  Film rest(record_width, record_height, {0, 0, record_width, record_height}, film.contents());
  rest.merge(part);
  CHECK_FALSE(first_difference(film, part));
  for (std::size_t layer = 0; layer < options.layers.size(); ++layer)
    CHECK(rest.value(layer, 5, 5) == film.value(layer, 5, 5));
}

TEST_CASE("texture coordinates are 0 where a shape has none") {
  const CameraSample sample[] = {{{.origin = {0.1f, 0.2f, 4}, .direction = {0, 0, -1}}, {}}};
  const auto recorded = [&](const Shape& shape) {
    Scene scene = ball_and_sky();
    scene.geometry = std::make_shared<const Geometry>(std::vector<Shape>{shape});
    std::vector<Records> records = records_of(scene, {}, sample);
    const Rgb uv = records[0].spans(1)[Layer::uv][0];
    CHECK(records[1].spans(1)[Layer::uv][0] == uv);
    return uv;
  };
  Mesh mesh{.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  CHECK(recorded(mesh) == Rgb{});
  CHECK(recorded(SphereSet{"ball", {{{0, 0, 0}, 1}}}) == Rgb{});
  mesh.uvs = {{3, 5}, {3, 5}, {3, 5}};
  mesh.uv_indices = mesh.triangles;
  CHECK(recorded(mesh).r == Approx(3));
  CHECK(recorded(mesh).g == Approx(5));
}

TEST_CASE("albedo and normal are those of the surface that is hit first, on the viewer's side") {
  const CameraSample samples[] = {{{.origin = {0, 0, 4}, .direction = {0.1f, 0.2f, -4}}, {}},
                                  {{.origin = {0, 0, 4}, .direction = {0, 0, 1}}, {}},
                                  {{.origin = {0, 0, 0}, .direction = {1, 0.2f, 0.1f}}, {}}};
  for (Records& records : records_of(ball_and_sky(), {.max_depth = 0}, samples)) {
    const auto albedo = records.spans(3)[Layer::albedo], normal = records.spans(3)[Layer::normal];
    CHECK(albedo[0] == Rgb{0.8f, 0.4f, 0.2f});
    CHECK(albedo[1] == Rgb{});
    CHECK(albedo[2] == albedo[0]);
    CHECK(normal[0].b > 0.9f);
    CHECK(normal[1] == Rgb{});
    CHECK(normal[2].r < -0.5f);  // Seen from within.
  }
}

TEST_CASE("a mirror has the albedo and the normal of what it shows, or else its own") {
  const auto features = [](const SurfaceModel& model, const PathOptions& options, const CameraSample& from) {
    std::vector<Records> both = records_of(mirror_before_wall(model), options, {&from, 1});
    const RecordSpans a = both[0].spans(1), b = both[1].spans(1);
    CHECK(a[Layer::albedo][0] == b[Layer::albedo][0]);
    CHECK(a[Layer::normal][0] == b[Layer::normal][0]);
    return std::pair(a[Layer::albedo][0], a[Layer::normal][0]);
  };
  const Mirror mirror{{0.5f, 1, 1}};
  const auto [seen, wall] = features(mirror, {.max_depth = 3}, towards_mirror);
  CHECK(seen.r == Approx(0.2f));
  CHECK(seen.g == Approx(0.6f));
  CHECK(wall == Rgb{0, 0, 1});
  // A path that is scattered no more than once sees the mirror alone, and so does one to the sky.
  const auto [own, floor] = features(mirror, {.max_depth = 1}, towards_mirror);
  CHECK(own == Rgb{0.5f, 1, 1});
  CHECK(floor == Rgb{0, 1, 0});
  const CameraSample to_sky{{.origin = {0, 2, -2}, .direction = {0, -2, 2}}, {}};
  CHECK(features(mirror, {.max_depth = 3}, to_sky).second == Rgb{0, 1, 0});
  // Behind a surface that scatters widely nothing is followed.
  const auto [matte, matte_floor] = features(Lambert{{0.5f, 1, 1}}, {.max_depth = 3}, towards_mirror);
  CHECK(matte == Rgb{0.5f, 1, 1});
  CHECK(matte_floor == Rgb{0, 1, 0});
}

TEST_CASE("what is seen through smooth glass keeps its albedo, whatever the glass does to radiance") {
  Scene scene = mirror_before_wall(Refraction{.ior = 1.5f});
  const CameraSample from{{.origin = {0, 2, 2}, .direction = {0, -2, -2}}, {}};
  for (Records& records : records_of(scene, {.max_depth = 5}, {&from, 1})) {
    CHECK(records.spans(1)[Layer::albedo][0].b == Approx(0.8f));
    CHECK(records.spans(1)[Layer::normal][0] == Rgb{0, 0, 1});
  }
}

TEST_CASE("depth, position, ids and coverage are those of the first surface, be it a mirror") {
  const CameraSample samples[] = {towards_mirror,
                                  {{.origin = {0, 2, 2}, .direction = {0, 1, 1}}, {}},
                                  {{.origin = {0, 2, 2}, .direction = {0, 0, -2}}, {}}};
  for (Records& made : records_of(mirror_before_wall(Mirror{}), {.max_depth = 3}, samples)) {
    const RecordSpans records = made.spans(3);
    CHECK(records[Layer::depth][0].r == Approx(1));
    CHECK(records[Layer::position][0].g == Approx(0).margin(off_edges));
    CHECK(records[Layer::position][0].b == Approx(0).margin(off_edges));
    CHECK(records[Layer::geometric_normal][0] == Rgb{0, 1, 0});
    CHECK(records[Layer::ids][0] == Rgb{1, 1, 0});
    CHECK(records[Layer::alpha][0].r == 1);
    CHECK(std::isnan(records[Layer::depth][1].r));
    CHECK(records[Layer::geometric_normal][1] == Rgb{});
    CHECK(records[Layer::alpha][1].r == 0);
    CHECK(records[Layer::depth][2].r == Approx(2.5f));
    CHECK(records[Layer::position][2].b == Approx(-3));
    CHECK(records[Layer::ids][2] == Rgb{2, 2, 0});
  }
}

TEST_CASE("mattes tell objects, materials and assets apart") {
  Scene scene = mirror_before_wall(Mirror{});
  scene.assets = {"rest", "room"};
  scene.bindings[0].asset = 1;
  scene.bindings[0].material = 1;
  const CameraSample samples[] = {towards_mirror,
                                  {{.origin = {0, 2, 2}, .direction = {0, 1, 1}}, {}},
                                  {{.origin = {0, 2, 2}, .direction = {0, 0, -2}}, {}}};
  for (Records& made : records_of(scene, {.max_depth = 3}, samples)) {
    const RecordSpans records = made.spans(3);
    // The wall belongs to nothing else: it stands behind the two assets.
    CHECK(recorded_id(records[Layer::asset_matte][2]) == 4);
    CHECK(recorded_id(records[Layer::object_matte][0]) == 1);
    CHECK(recorded_id(records[Layer::material_matte][0]) == 2);
    CHECK(recorded_id(records[Layer::asset_matte][0]) == 2);
    for (const Layer layer : {Layer::object_matte, Layer::material_matte, Layer::asset_matte})
      CHECK(recorded_id(records[layer][1]) == 0);
  }
}

TEST_CASE("shapes of one material have one material id") {
  Scene scene = mirror_before_wall(Mirror{});
  scene.bindings[1].material = 0;
  const CameraSample to_wall{{.origin = {0, 2, 2}, .direction = {0, 0, -2}}, {}};
  for (Records& records : records_of(scene, {}, {&to_wall, 1}))
    CHECK(records.spans(1)[Layer::ids][0] == Rgb{2, 1, 0});
}

TEST_CASE("an environment covers the picture, other distant light does not") {
  Scene scene = ball_and_sky();
  add_light(scene, SunLight{{0, -1, 0}, {1, 1, 1}, 1});
  CHECK_FALSE(has_environment(scene));
  const CameraSample away{{.origin = {0, 0, 4}, .direction = {0, 0, 1}}, {}};
  for (Records& records : records_of(scene, {}, {&away, 1})) CHECK(records.spans(1)[Layer::alpha][0].r == 0);
  add_light(scene, EnvironmentLight{std::make_shared<const Image>(2, 1)});
  CHECK(has_environment(scene));
  for (Records& records : records_of(scene, {}, {&away, 1})) CHECK(records.spans(1)[Layer::alpha][0].r == 1);
}

TEST_CASE("an integrator that knows nothing of a layer leaves it blank") {
  const Scene scene = ball_and_sky();
  const Film film =
      render_with(scene, NormalsIntegrator(scene), with_layers({Layer::albedo, Layer::depth})).film;
  CHECK_FALSE(is_black(film.pixel(record_width / 2, record_height / 2).mean()));
  CHECK(is_black(film.value(0, record_width / 2, record_height / 2)));
  CHECK(film.value(1, record_width / 2, record_height / 2).r == layer_info(Layer::depth).nothing);
}

TEST_CASE("no layer of a render comes twice") {
  const Scene scene = ball_and_sky();
  CHECK_THROWS_AS(render_with(scene, NormalsIntegrator(scene), with_layers({Layer::normal, Layer::normal})),
                  Error);
}

}  // namespace twinray::test
