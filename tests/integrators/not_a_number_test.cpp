// SPDX-License-Identifier: Apache-2.0
// Where numbers fail: points of a light that coincide with the point that is shaded, and indices of
// refraction as large as no material has them. Waves have the reference's bits there, too, by every
// instruction set.
#include "integrators/path.h"
#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {

TEST_CASE("waves have the reference's bits where points of a light coincide with the one that is shaded") {
  const Vec3 far{100000, 100000, 100000};  // Where coordinates are multiples of 1/128.
  Mesh floor = floor_square(0.02f, 0);
  for (Vec3& p : floor.positions) p = p + far;
  Scene scene = scene_of(floor, {0.5f, 0.5f, 0.5f}, far + Vec3{0.01f, 0.06f, 0.01f}, far);
  scene.lights = {{"floor", MeshLight{.shape = 0, .radiance = {1, 1, 1}, .side = EmissionSide::both}}};
  scene.bindings[0].light = 0;
  check_waves(scene);
}

TEST_CASE("waves reject the samples that the reference rejects: light without bound on a black surface") {
  constexpr float tiny = 1e-20f;  // Whose square divides to infinity.
  Scene scene = scene_of(floor_square(tiny, 0), {0, 0, 0}, {0, 1, 1}, {});
  scene.camera.position = Vec3{0, 1, 1} * tiny;
  add_light(scene, PointLight{{0, 0.25f * tiny, 0}, {1, 1, 1}, {}});
  const RenderResult seen =
      render_with(scene, PathReference(scene, {}), {.width = 24, .height = 18, .samples = 4});
  CHECK(seen.film.rejected_count() > 0);
  const RenderResult waves =
      render_with(scene, PathIntegrator(scene, {}), {.width = 24, .height = 18, .samples = 4});
  CHECK(waves.film.rejected_count() == seen.film.rejected_count());
  check_waves(scene);
}

TEST_CASE("a white surface is lit below gloss of any index of refraction") {
  for (const float ior : {1.5f, 100.0f, 1000.0f, 1e6f}) {
    CAPTURE(ior);
    Principled white_gloss;
    white_gloss.base_color = {1, 1, 0.5f};
    white_gloss.specular_ior = ior;
    white_gloss.specular_roughness = 0.13f;
    const Scene scene = ball_under_sky(white_gloss);
    const RenderResult seen =
        render_with(scene, PathIntegrator(scene, {}), {.width = 24, .height = 18, .samples = 16});
    CHECK(seen.film.rejected_count() == 0);
    check_waves(scene);
  }
}

}  // namespace twinray::test
