// SPDX-License-Identifier: Apache-2.0
// Light by path: to which part each bit of it belongs, and that the parts add up.
#include "integrators/light_paths.h"

#include <map>

#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/film.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_records.h"

namespace twinray::test {
namespace {

RenderOptions with_paths(std::uint32_t samples) {
  RenderOptions options = small_picture(samples);
  options.light_paths = true;
  return options;
}

/// The sum of each part over the whole picture, those that are black left out.
std::map<LightPath, double> parts_of(const Film& film) {
  std::map<LightPath, double> parts;
  for (int y = 0; y < film.frame_height(); ++y)
    for (int x = 0; x < film.frame_width(); ++x) {
      const std::vector<Rgb> values = parts_at(film, Division::paths, x, y);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (!is_black(values[i])) parts[LightPath(i)] += luminance(values[i]);
    }
  return parts;
}

std::vector<LightPath> lit_parts(const Scene& scene, const PathOptions& path) {
  std::vector<LightPath> lit;
  for (const auto& [part, sum] :
       parts_of(render_with(scene, PathIntegrator(scene, path), with_paths(64)).film))
    lit.push_back(part);
  return lit;
}

}  // namespace

TEST_CASE("the parts of a picture's light give its colours, added up as floats, in any order") {
  const Scene scene = small_room();
  for (const PathOptions& path : {PathOptions{.max_depth = 4}, PathOptions{.max_depth = 4, .clamp = 0.2f},
                                  PathOptions{.max_depth = 3, .direct = DirectMethod::hemisphere},
                                  PathOptions{.max_depth = 4, .first_depth = 2}}) {
    const Film film = render_with(scene, PathIntegrator(scene, path), with_paths(8)).film;
    CHECK(parts_of(film).size() >= 1);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        const std::vector<Rgb> parts = parts_at(film, Division::paths, x, y);
        Rgb forward, backward;
        for (std::size_t i = 0; i < parts.size(); ++i) {
          forward += parts[i];
          backward += parts[parts.size() - 1 - i];
        }
        CHECK(forward == film.pixel(x, y).mean());
        CHECK(backward == forward);
      }
  }
}

TEST_CASE("the colours of a picture do not depend on whether their parts are asked for") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 4});
  const Film with = render_with(scene, path, with_paths(8)).film;
  const Film without = render_with(scene, path, small_picture(8)).film;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) CHECK(with.pixel(x, y) == without.pixel(x, y));
}

TEST_CASE("the parts of light that a mix of diffuse surfaces reflects are those of the reference") {
  Scene scene = scene_of(floor_square(2, 0), {0.6f, 0.5f, 0.4f}, {0, 3, 2}, {0, -1, -0.6f});
  for (const float x : {-2.0f, 2.0f})
    add_lamp(scene, SphereSet{"lamp", {{{x, 2, 1}, 0.5f}}}, {7 + x, 8, 9}, EmissionSide::front);
  add_light(scene, constant_sky({0.3f, 0.2f, 0.4f}));
  const auto black = std::uint32_t(scene.materials.size());  // So that the mix is what it is mixed of.
  scene.materials.push_back({"black", Lambert{}});
  scene.materials.push_back({"mix", Mix{0, black, 0.25f}});
  for (ShapeBinding& binding : scene.bindings)
    if (binding.material == 0) binding.material = black + 1;
  for (const PathOptions& path :
       {PathOptions{.max_depth = 2, .samples_per_light = 3},
        PathOptions{.max_depth = 1, .direct = DirectMethod::hemisphere, .samples_per_light = 2}}) {
    const Film waves = render_with(scene, PathIntegrator(scene, path), with_paths(8)).film;
    const Film reference = render_with(scene, PathReference(scene, path), with_paths(8)).film;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        CHECK(parts_at(waves, Division::paths, x, y) == parts_at(reference, Division::paths, x, y));
  }
}

TEST_CASE("what a sample's parts lack of its radiance is rounding") {
  constexpr std::uint32_t count = 300;
  Records records = traced_records(small_room(), {.max_depth = 5}, {{}, {light_path_count, 0}}, count);
  const RecordSpans made = records.spans(count);
  double scattered = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Rgb sum;
    for (const Rgb& part : made[Division::paths][i]) sum += part;
    CHECK(luminance(sum) == Approx(luminance(made.color()[i])).epsilon(1e-5));
    scattered += luminance(sum);
  }
  CHECK(scattered > 0);
}

TEST_CASE("light of one channel alone belongs to its part as any other does") {
  for (const Rgb& term : {Rgb{2, 0, 0}, Rgb{0, 2, 0}, Rgb{0, 0, 2}}) {
    std::vector<Rgb> parts(light_path_count);
    add_scattered_light({.diffuse = {0.25f, 0.25f, 0.25f}}, term, 2, PathParts(parts));
    CHECK(PathParts(parts)[LightPath::diffuse_indirect] == term * 0.25f);
    CHECK(PathParts(parts)[LightPath::glossy_indirect] == term * 0.75f);
  }
}

TEST_CASE("light belongs to the way in which the first surface scattered it") {
  using enum LightPath;
  const auto lit = [](const SurfaceModel& model) {
    return lit_parts(ball_under_sky(model), {.max_depth = 5});
  };
  CHECK(lit(Lambert{{0.5f, 0.5f, 0.5f}}) == std::vector{diffuse_direct});
  CHECK(lit(RoughDiffuse{}) == std::vector{diffuse_direct});
  CHECK(lit(Mirror{}) == std::vector{glossy_direct});
  CHECK(lit(Conductor{.roughness = {0.3f, 0.3f}}) == std::vector{glossy_direct});
  CHECK(lit(DiffuseTransmission{{0.4f, 0.4f, 0.4f}, {0.4f, 0.4f, 0.4f}}) ==
        std::vector{diffuse_direct, transmission_indirect});
  CHECK(lit(Dielectric{}) == std::vector{glossy_direct, transmission_indirect});
  CHECK(lit(CoatedDiffuse{.reflectance = {0.5f, 0.5f, 0.5f}, .roughness = {0.3f, 0.3f}}) ==
        std::vector{diffuse_direct, glossy_direct});
}

TEST_CASE("light through a surface is transmission, be it sampled at the light or by the surface") {
  // A paper lit from behind by a lamp that only its other side sees.
  Scene scene = scene_of(floor_square(1, 0), {}, {0, 2, 0.1f}, {0, 0, 0});
  scene.materials[0].model = DiffuseTransmission{{}, {0.8f, 0.8f, 0.8f}};
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.1f;
  Mesh lamp = floor_square(1, -1);
  add_lamp(scene, std::move(lamp), {1, 1, 1}, EmissionSide::front);
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights, DirectMethod::hemisphere})
    CHECK(lit_parts(scene, {.max_depth = 1, .direct = method}) ==
          std::vector{LightPath::transmission_direct});
}

TEST_CASE("what the camera sees directly is emission where it hits something, else environment") {
  using enum LightPath;
  Scene scene = ball_under_sky(Lambert{});
  scene.camera = camera_at({0, 0, 3}, {0, 0, 6});
  CHECK(lit_parts(scene, {}) == std::vector{environment});
  const Scene enclosure = emissive_enclosure(1, 0.5f);
  CHECK(lit_parts(enclosure, {.max_depth = 0}) == std::vector{emission});
  CHECK(lit_parts(enclosure, {.max_depth = 1}) == std::vector{emission, diffuse_direct});
  CHECK(lit_parts(enclosure, {.max_depth = 3}) == std::vector{emission, diffuse_direct, diffuse_indirect});
}

TEST_CASE("an enclosure's parts are the terms of its series") {
  const Scene scene = emissive_enclosure(1, 0.5f);
  const auto parts =
      parts_of(render_with(scene, PathIntegrator(scene, {.max_depth = 3}), with_paths(256)).film);
  constexpr double noise = 0.05;
  CHECK(parts.at(LightPath::emission) == Approx(16));
  CHECK(parts.at(LightPath::diffuse_direct) == Approx(16 * 0.5).epsilon(noise));
  CHECK(parts.at(LightPath::diffuse_indirect) == Approx(16 * (0.25 + 0.125)).epsilon(noise));
}

TEST_CASE("enamel's coat is glossy, its base diffuse: each as bright as it would be alone") {
  const CoatedDiffuse enamel{.reflectance = {0.5f, 0.5f, 0.5f}, .roughness = {0.3f, 0.3f}};
  CoatedDiffuse black = enamel;
  black.reflectance = {};
  const auto parts = [](const SurfaceModel& model) {
    const Scene scene = ball_under_sky(model);
    return parts_of(render_with(scene, PathIntegrator(scene, {.max_depth = 1}), with_paths(4096)).film);
  };
  constexpr double noise = 0.03;
  CHECK(parts(enamel)[LightPath::glossy_direct] ==
        Approx(parts(black)[LightPath::glossy_direct]).epsilon(noise));
  CHECK(parts(enamel)[LightPath::diffuse_direct] > 2 * parts(enamel)[LightPath::glossy_direct]);
}

TEST_CASE("under a filter with negative values the parts are weighted as the colours") {
  Scene scene = small_room();
  const Vec3 ahead = scene.camera.position + scene.camera.forward;
  add_lamp(scene, SphereSet{"bulb", {{ahead, 0.05f}}}, {50, 40, 30}, EmissionSide::front);
  RenderOptions options = with_paths(16);
  options.width = options.height = 12;
  options.filter = usual_filter(FilterKind::mitchell);
  const Film film = render_with(scene, PathIntegrator(scene, {.max_depth = 3}), options).film;
  bool has_negative = false;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      double sum = 0, largest = 0;
      for (const Rgb& part : parts_at(film, Division::paths, x, y)) {
        sum += part.r;
        largest = std::max(largest, std::fabs(double(part.r)));
        has_negative = has_negative || part.r < 0;
      }
      CHECK(sum == Approx(film.pixel(x, y).mean().r).epsilon(0).margin(1e-7 * largest));
    }
  CHECK(has_negative);
}

}  // namespace twinray::test
