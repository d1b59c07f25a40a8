// SPDX-License-Identifier: Apache-2.0
// Normals by which surfaces shade: those that lean so far that mirrors would show what is below them.
#include "integrators/shading_frame.h"

#include <cmath>

#include "core/angle.h"
#include "core/image.h"
#include "core/random.h"
#include "integrators/path.h"
#include "tests/support/catch.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// A ball of 80 triangles with a sphere's normals.
Mesh coarse_ball() {
  Mesh mesh = icosphere(1);
  mesh.normals = mesh.positions;
  mesh.normal_indices = mesh.triangles;
  return mesh;
}

Scene coarse_ball_of(const SurfaceModel& model) {
  Scene scene = scene_of(coarse_ball(), {}, {0, 0, 3.2f}, {0, 0, 0});
  scene.materials[0].model = model;
  add_light(scene, constant_sky({1, 1, 1}));
  return scene;
}

const SurfaceModel white_metal = Mirror{{1, 1, 1}};

/// Of a point whose geometric normal is +z.
SurfacePoint leaning(const Vec3& shading) {
  SurfacePoint point;
  point.geometric_normal = {0, 0, 1};
  point.shading_normal = shading;
  return point;
}

Vec3 mirrored(const Vec3& wo, const Vec3& normal) { return normal * (2 * dot(wo, normal)) - wo; }

}  // namespace

TEST_CASE("a mirror's normal reflects to above the true surface, and is as it was where it does") {
  Scene scene = coarse_ball_of(white_metal);
  Random random(5);
  int bent = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 wo = normalize(random.in_ball()), normal = normalize(random.in_ball() + Vec3{0, 0, 1});
    const Vec3 above = facing({0, 0, 1}, wo);
    const Vec3 shading = shading_frame(scene, scene.materials[0], leaning(normal), wo).frame.normal;
    const Vec3 given = facing(normal, above);
    const float cosine = dot(mirrored(wo, shading), above);
    CHECK(length(shading) == Approx(1));
    CHECK(dot(shading, wo) > 0);
    CHECK(cosine > std::min(0.0089f, 0.89f * dot(wo, above)));
    if (dot(given, wo) <= 0) continue;  // The viewer is behind it.
    const float before = dot(mirrored(wo, given), above);
    if (before > 0.0101f) CHECK(shading == given);
    if (before >= 0) continue;
    ++bent;
    CHECK(cosine < 1e-4f + 0.01f / std::sqrt(1 - before * before));  // No further than it must.
    CHECK(dot(cross(given, wo), cross(shading, wo)) > 0);            // It leans to the same side.
  }
  CHECK(bent > 100);
}

TEST_CASE("what has no mirror in it shades by its own normal") {
  const Vec3 wo = normalize(Vec3{0.9f, 0, 0.3f}), normal = normalize(Vec3{-0.2f, 0, 1});
  for (const SurfaceModel& model :
       {SurfaceModel(Lambert{}), SurfaceModel(RoughDiffuse{}), SurfaceModel(DiffuseTransmission{})}) {
    const Scene scene = coarse_ball_of(model);
    CHECK(shading_frame(scene, scene.materials[0], leaning(normal), wo).frame.normal == normal);
  }
  const Scene metal = coarse_ball_of(white_metal);
  CHECK(shading_frame(metal, metal.materials[0], leaning(normal), wo).frame.normal != normal);
}

TEST_CASE("a white metal ball of few triangles with a sphere's normals is as bright as its sky") {
  const Scene scene = coarse_ball_of(white_metal);
  const Image image = mean_image(
      render_with(scene, PathIntegrator(scene, {.max_depth = 3}), {.width = 40, .height = 40, .samples = 4})
          .film);
  for (const Rgb& pixel : image.pixels) CHECK(pixel.g == Approx(1).epsilon(1e-3));
}

TEST_CASE("waves and all engines bend normals alike") {
  check_waves(coarse_ball_of(Conductor{.eta = {0.2f, 0.9f, 1}, .k = {4, 2, 2}, .roughness = {0.2f, 0.2f}}));
  check_waves(coarse_ball_of(CoatedDiffuse{}));
}

}  // namespace twinray::test
