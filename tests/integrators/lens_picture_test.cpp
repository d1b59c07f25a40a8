// SPDX-License-Identifier: Apache-2.0
// Pictures through a lens system (core/lens_system.h): what it leaves of the light, and what layers show.
#include <cmath>
#include <tuple>

#include "core/angle.h"
#include "integrators/normals.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/lens.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// Nothing but a white sky is in view.
Scene white_sky() {
  Scene scene = scene_of(floor_square(0.1f, -50), {0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0, 0, -1});
  scene.lights.push_back({"sky", constant_sky({1, 1, 1})});
  scene.camera = camera_with_lens_system();
  return scene;
}

/// A lamp in focus that covers the right half of the frame, and some more.
Scene half_lit(const Camera& camera) {
  Scene scene = scene_of(floor_square(0.01f, 9), {0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0, 0, -1});
  Mesh square{"lamp", {{0, -3, -4}, {3, -3, -4}, {3, 3, -4}, {0, 3, -4}}, {{0, 1, 2}, {0, 2, 3}}};
  add_lamp(scene, std::move(square), {1, 1, 1}, EmissionSide::both);
  scene.camera = camera;
  return scene;
}

Film picture(const Scene& scene, const Integrator& integrator, const RenderOptions& options) {
  return render_with(scene, integrator, options).film;
}

RenderOptions square_picture(std::uint32_t samples) {
  return {.width = 16, .height = 16, .samples = samples, .threads = 1};
}

}  // namespace

TEST_CASE("a white sky in the middle of the frame is as bright as the cone of light is wide") {
  const Scene scene = white_sky();
  const Film film = picture(scene, PathIntegrator(scene, {}), square_picture(4096));
  const double from_film = scene.camera.lenses->surfaces().back().thickness, stop = 0.125;
  const double middle = pi_double * stop * stop / (stop * stop + from_film * from_film);
  CHECK(film.pixel(7, 8).luminance_mean() == Approx(middle).epsilon(0.02));
  CHECK(film.pixel(8, 7).luminance_mean() == Approx(middle).epsilon(0.02));
  // The corner's middle is 15 / 16 of the way to it.
  const double away = 0.2 * std::sqrt(2.0) * 15 / 16, cosine = from_film / std::hypot(from_film, away);
  CHECK(film.pixel(0, 15).luminance_mean() == Approx(middle * std::pow(cosine, 4)).epsilon(0.03));
}

TEST_CASE("layers do not count the light that a lens leaves") {
  const Scene scene = white_sky();
  RenderOptions options = square_picture(64);
  options.layers = {Layer::alpha};
  const Film film = picture(scene, PathIntegrator(scene, {}), options);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) CHECK(film.value(0, x, y).r == 1);
  CHECK(film.pixel(8, 8).luminance_mean() < 0.1);
}

TEST_CASE("depths behind a lens are those from the film, and what is clipped is so for all samples") {
  Scene scene = half_lit(camera_with_lens_system());
  RenderOptions options = square_picture(64);
  options.layers = {Layer::alpha, Layer::depth};
  const Film film = picture(scene, PathIntegrator(scene, {}), options);
  for (int y = 0; y < 16; ++y) CHECK(film.value(1, 15, y).r == Approx(4).epsilon(1e-5));
  for (const bool by_distance : {false, true})
    for (const auto& [near, far, alpha] :
         {std::tuple{3.9f, 4.3f, 1.0f}, {0.0f, 3.9f, 0.0f}, {4.3f, 9.0f, 0.0f}}) {
      scene.camera.clip_near = near, scene.camera.clip_far = far;
      scene.camera.clips_by_distance = by_distance;
      const Film clipped = picture(scene, PathIntegrator(scene, {}), options);
      CHECK(clipped.value(0, 15, 8).r == alpha);
      CHECK((clipped.pixel(15, 8).luminance_mean() > 0) == (alpha > 0));
    }
}

TEST_CASE("layers that are asked for change no light behind a lens") {
  const Scene scene = half_lit(camera_with_lens_system());
  RenderOptions options = square_picture(16);
  const Film plain = picture(scene, PathIntegrator(scene, {}), options);
  options.layers = {Layer::alpha, Layer::normal};
  const Film layered = picture(scene, PathIntegrator(scene, {}), options);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) CHECK(plain.pixel(x, y).mean() == layered.pixel(x, y).mean());
}

TEST_CASE("what a lens shows is not mirrored, and sharp where its focus is") {
  const Scene scene = half_lit(camera_with_lens_system());
  // The film's middle is where the camera is; 5 from it things are sharp.
  Scene in_focus = scene;
  in_focus.camera.position = {0, 0, 1};
  Scene blurred = scene;
  blurred.camera.position = {0, 0, -2};
  const Film sharp = picture(in_focus, PathIntegrator(in_focus, {}), square_picture(256));
  const Film soft = picture(blurred, PathIntegrator(blurred, {}), square_picture(256));
  const auto at = [](const Film& film, int x) { return film.pixel(x, 8).luminance_mean(); };
  CHECK(at(sharp, 6) < 1e-3);
  CHECK(at(sharp, 9) > 0.02);
  CHECK(at(sharp, 12) == Approx(at(sharp, 9)).epsilon(0.1));
  CHECK(at(soft, 6) > 1e-3);
  CHECK(at(soft, 7) > at(soft, 6));
  CHECK(at(soft, 9) > at(soft, 7));
}

TEST_CASE("a lens dims what is light and nothing else") {
  const Scene scene = half_lit(camera_with_lens_system());
  Scene in_focus = scene;
  in_focus.camera.position = {0, 0, 1};
  const NormalsIntegrator normals(in_focus);
  const Film film = picture(in_focus, normals, square_picture(64));
  CHECK(film.pixel(12, 8).mean().b == Approx(1));  // (n + 1) / 2 of a normal along +z.
}

TEST_CASE("the reference has the bits of waves behind a lens, with every sampler") {
  const Scene scene = half_lit(camera_with_lens_system());
  for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
    RenderOptions options = square_picture(8);
    options.sampler = sampler;
    const Film waves = picture(scene, PathIntegrator(scene, {}), options);
    CHECK(same_bits(waves, picture(scene, PathReference(scene, {}), options)));
    CHECK(waves.pixel(12, 8).luminance_mean() > 0);
  }
}

TEST_CASE("a frame that is widened shows the lens's own film in its middle, and more beside it") {
  Scene scene = white_sky();
  RenderOptions wide = square_picture(2048);
  wide.width = 48, wide.height = 4;
  const Film film = picture(scene, PathIntegrator(scene, {}), wide);
  CHECK(film.pixel(0, 1).luminance_mean() > 0);  // Beyond the radius of which pupils are known.
  CHECK(film.pixel(0, 1).luminance_mean() < film.pixel(12, 1).luminance_mean());
  CHECK(film.pixel(47, 1).luminance_mean() == Approx(film.pixel(0, 1).luminance_mean()).epsilon(0.1));
}

}  // namespace twinray::test
