// SPDX-License-Identifier: Apache-2.0
// Light by groups of lights: each has what its lights bring, and together they are the picture.
#include "integrators/light_groups.h"

#include <atomic>

#include "core/error.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/film_bytes.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_records.h"
#include "tests/support/wave_scenes.h"

namespace twinray::test {
namespace {

RenderOptions with_groups(std::uint32_t samples) {
  RenderOptions options = small_picture(samples);
  options.light_groups = true;
  return options;
}

Light sky(const Rgb& radiance) {
  Image map(1, 1);
  map.pixels[0] = radiance;
  return {"sky", EnvironmentLight{std::make_shared<const Image>(map)}};
}

/// A floor and a mirror ball with a lamp, points and a sky, each a group of its own; `lit`: which shine.
Scene studio(std::span<const bool, 3> lit, std::size_t points = 1) {
  const auto strength = [&](std::size_t i) { return lit[i] ? Rgb{2, 1, 0.5f} : Rgb{}; };
  Scene scene = scene_of(floor_square(2, 0), {0.7f, 0.7f, 0.7f}, {0, 2, 4}, {0, 0.3f, 0});
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(SphereSet{"ball", {{{0, 0.5f, 0}, 0.5f}}});
  scene.materials.push_back({"mirror", Mirror{{0.9f, 0.9f, 0.9f}}});
  scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1)});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  add_lamp(scene, floor_square(0.5f, 3), strength(0), EmissionSide::both);
  for (std::size_t i = 0; i < points; ++i)
    add_light(scene, PointLight{{-1 + 0.1f * float(i), 2, 1}, strength(1), {}});
  scene.lights.push_back(sky(strength(2)));
  scene.light_groups = {"lamp", "points", "sky"};
  for (std::size_t i = 1; i < scene.lights.size(); ++i) scene.lights[i].group = 1;
  scene.lights.back().group = 2;
  return scene;
}

Rgb sum_of(std::span<const Rgb> groups) { return groups[0] + groups[1] + groups[2]; }

constexpr bool all_lit[] = {true, true, true};

const std::vector<PathOptions> methods{{.max_depth = 4},
                                       {.max_depth = 4, .direct = DirectMethod::lights},
                                       {.max_depth = 4, .clamp = 0.05f},
                                       {.max_depth = 3, .direct = DirectMethod::hemisphere}};

Rgb color_of(const SampleKey& key) { return {0.1f * float(key.x), 0.3f * float(key.y), float(key.index)}; }

/// Knows of no light groups, and remembers whether it was asked for them.
class PlaceIntegrator final : public Integrator {
 public:
  void sample(std::span<const CameraSample> samples, SamplerKind, Tracer&,
              const RecordSpans& records) const override {
    if (records.has(Division::groups)) was_asked_for_groups = true;
    for (std::size_t i = 0; i < samples.size(); ++i) records.color()[i] = color_of(samples[i].key);
  }
  mutable std::atomic<bool> was_asked_for_groups = false;
};

}  // namespace

TEST_CASE("the one light group of a scene has all of the radiance, sample by sample") {
  Scene scene = studio(all_lit);
  const PlaceIntegrator integrator;
  const RenderOptions options = with_groups(3);
  render_with(scene, integrator, options);
  CHECK(integrator.was_asked_for_groups);
  for (Light& light : scene.lights) light.group = 0;
  scene.light_groups = {"all"};
  const PlaceIntegrator of_one_group;
  const Film film = render_with(scene, of_one_group, options).film;
  CHECK_FALSE(of_one_group.was_asked_for_groups);
  Film expected(options.width, options.height, window_of(options), film.contents());
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x)
      for (std::uint32_t index = 0; index < 3; ++index) {
        const Rgb color = color_of({.x = std::uint32_t(x), .y = std::uint32_t(y), .index = index});
        add_sample(expected, x, y, index, {color, {}, {}, {color}});
      }
  CHECK(bytes_of(film) == bytes_of(expected));
}

TEST_CASE("the light groups of a picture give its colours, added up as floats, in any order") {
  const Scene scene = studio(all_lit);
  for (const PathOptions& path : methods) {
    const Film film = render_with(scene, PathIntegrator(scene, path), with_groups(8)).film;
    for (int y = 0; y < film.frame_height(); ++y)
      for (int x = 0; x < film.frame_width(); ++x) {
        const std::vector<Rgb> groups = parts_at(film, Division::groups, x, y);
        REQUIRE(groups.size() == 3);
        CHECK((groups[0] + groups[1]) + groups[2] == film.pixel(x, y).mean());
        CHECK((groups[2] + groups[1]) + groups[0] == film.pixel(x, y).mean());
      }
  }
}

TEST_CASE("what a sample's groups lack of its radiance is rounding, in mirrors as elsewhere") {
  const Scene scene = studio(all_lit);
  constexpr std::uint32_t count = 300;
  for (const PathOptions& path : methods) {
    Records records = traced_records(scene, path, {{}, {0, 3}}, count);
    const RecordSpans made = records.spans(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      constexpr double rounding = 1e-5;
      CHECK(luminance(sum_of(made[Division::groups][i])) ==
            Approx(luminance(made.color()[i])).epsilon(rounding));
    }
  }
}

TEST_CASE("a light group is the picture that its lights make alone") {
  const Scene scene = studio(all_lit);
  for (const PathOptions& path : {methods[0], methods[1], methods[3]}) {
    const Film film = render_with(scene, PathIntegrator(scene, path), with_groups(16)).film;
    for (std::size_t group = 0; group < 3; ++group) {
      bool lit[3] = {};
      lit[group] = true;
      const Scene one = studio(lit);
      const Film alone = render_with(one, PathIntegrator(one, path), small_picture(16)).film;
      double light = 0;
      for (int y = 0; y < film.frame_height(); ++y)
        for (int x = 0; x < film.frame_width(); ++x) {
          CAPTURE(group, x, y);
          constexpr double rounding = 1e-4;
          const double expected = luminance(alone.pixel(x, y).mean());
          CHECK(luminance(parts_at(film, Division::groups, x, y)[group]) ==
                Approx(expected).epsilon(rounding).margin(rounding));
          light += expected;
        }
      // Directions alone never find a point.
      CHECK((light > 0) == (group != 1 || path.direct != DirectMethod::hemisphere));
    }
  }
}

TEST_CASE("waves have the groups of the path tracer that traces one path after the other") {
  for (const std::size_t points : {1, 20}) {
    const Scene scene = studio(all_lit, points);
    for (const PathOptions& path : methods)
      CHECK(same_bits(render_with(scene, PathIntegrator(scene, path), with_groups(8)).film,
                      render_with(scene, PathReference(scene, path), with_groups(8)).film));
  }
}

TEST_CASE("waves have the groups of the path tracer for lamps that are chosen from") {
  Scene scene = scene_of_many_lights();
  scene.light_groups = {"first", "second", "third"};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].group = std::uint32_t(i % 3);
  const PathOptions path{.max_depth = 2};
  RenderOptions options = with_groups(4);
  options.width = options.height = 24;
  CHECK(same_bits(render_with(scene, PathIntegrator(scene, path), options).film,
                  render_with(scene, PathReference(scene, path), options).film));
}

TEST_CASE("of many lights that are chosen from, each brings light to its own group") {
  Scene scene = studio(std::array{false, true, false}, 20);
  scene.light_groups = {"rest", "even", "odd"};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].group = 0;
  for (std::size_t i = 1; i + 1 < scene.lights.size(); ++i) scene.lights[i].group = 1 + i % 2;
  const Film film = render_with(scene, PathIntegrator(scene, {.max_depth = 2}), with_groups(64)).film;
  double light[3] = {};
  for (int y = 0; y < film.frame_height(); ++y)
    for (int x = 0; x < film.frame_width(); ++x)
      for (std::size_t group = 0; group < 3; ++group)
        light[group] += luminance(parts_at(film, Division::groups, x, y)[group]);
  CHECK(light[0] == 0);
  constexpr double noise = 0.3;
  CHECK(light[1] == Approx(light[2]).epsilon(noise));
  CHECK(light[1] > 0);
}

TEST_CASE("what clamping takes from the light it takes from each group alike") {
  const Scene scene = studio(all_lit);
  const auto brightest = [&](float clamp) {
    constexpr std::uint32_t count = 68;
    Records records =
        traced_records(scene, {.max_depth = 2, .first_depth = 2, .clamp = clamp}, {{}, {0, 3}}, count);
    float most = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      most = std::max(most, max_component(sum_of(records.spans(count)[Division::groups][i])));
    return most;
  };
  constexpr float clamp = 1e-3f, two_terms = 2.01f * clamp;  // Direct light, and what a ray finds.
  CHECK(brightest(clamp) <= two_terms);
  CHECK(brightest(clamp) > 0.5f * clamp);
  CHECK(brightest(1e9f) > 10 * clamp);
}

TEST_CASE("ambient light has a group, and the camera does not see it") {
  Scene scene = scene_of(floor_square(1, 0), {0.7f, 0.7f, 0.7f}, {0, 2, 4}, {0, 0.3f, 0});
  add_light(scene, AmbientLight{{0, 1, 0}, {1, 1, 1}});
  add_light(scene, PointLight{{0, 2, 0}, {1, 1, 1}, {}});
  scene.light_groups = {"ambient", "point"};
  scene.lights[1].group = 1;
  scene.camera = camera_at({0, 1, 0}, {0, 5, 0});
  const Film film = render_with(scene, PathIntegrator(scene, {.max_depth = 1}), with_groups(1)).film;
  for (const Rgb& group : parts_at(film, Division::groups, 0, 0)) CHECK(is_black(group));
  const auto engine = build_accelerator(Backend::brute_force, scene.geometry);
  Records records({{}, {0, 2}}, 1);
  Tracer tracer(*engine, false);
  const CameraSample away{{.origin = {0, 1, 0}, .direction = {0, 1, 0}}, {}};
  PathReference(scene, {}).sample({&away, 1}, SamplerKind::independent, tracer, records.spans(1));
  CHECK(is_black(records.spans(1)[Division::groups][0][0]));
}

TEST_CASE("a light's group is one of the scene's") {
  Scene scene = studio(all_lit);
  scene.lights[1].group = 3;
  CHECK_THROWS_WITH(check_scene(scene), "light 1 names group 3; there are 3");
  scene = studio(all_lit);
  scene.assets = {"one"};
  scene.bindings[2].asset = 1;
  CHECK_THROWS_WITH(check_scene(scene), "shape 2 names asset 1; there are 1");
}

}  // namespace twinray::test
