// SPDX-License-Identifier: Apache-2.0
// Surfaces and emitters with holes: against real geometry, against closed forms, and the same bits from waves
// and all engines.
#include <cmath>

#include "integrators/path_reference.h"
#include "tests/support/catch.h"
#include "tests/support/cut_outs.h"
#include "tests/support/engines.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace twinray::test {
namespace {

constexpr int cells = 16;

/// Whether a cell of the unit square belongs to a leaf: an ellipse with a notch.
bool is_leaf(int column, int row) {
  const float x = (float(column) + 0.5f) / cells - 0.5f, y = (float(row) + 0.5f) / cells - 0.5f;
  return x * x * 4.5f + y * y * 16 < 1 && !(x > 0.2f && std::fabs(y) < 0.05f);
}

/// Row 0 of a picture is its top, v = 1.
Texture leaf_alpha() {
  Image picture(cells, cells);
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const float alpha = is_leaf(column, cells - 1 - row) ? 1 : 0;
      picture.at(column, row) = {alpha, alpha, alpha};
    }
  ImageTexture image{.image = std::make_shared<const MipMap>(std::move(picture))};
  image.filter = TextureFilter::nearest;
  return {"leaf", image};
}

/// A square [-1, 1]^2 at a height, u along x and v along -z.
Mesh leaf_square(float y) {
  Mesh mesh = floor_square(1, y);
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.uv_indices = mesh.triangles;
  return mesh;
}

/// The leaf's cells alone.
Mesh leaf_mesh(float y) {
  Mesh mesh;
  const auto at = [&](int column, int row) {
    return Vec3{2 * float(column) / cells - 1, y, 1 - 2 * float(row) / cells};
  };
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      if (!is_leaf(column, row)) continue;
      add_triangle(mesh, at(column, row), at(column + 1, row), at(column + 1, row + 1));
      add_triangle(mesh, at(column, row), at(column + 1, row + 1), at(column, row + 1));
    }
  return mesh;
}

/// A leaf that hangs over a floor below a lamp, seen from the side: as a shape, cut out or not.
Scene leaf_scene(Mesh leaf, bool is_cut_out) {
  Scene scene = scene_of(floor_square(3, -0.7f), {0.6f, 0.7f, 0.8f}, {1.5f, 2.5f, 3}, {0, 0, 0});
  add_lamp(scene, floor_square(0.4f, 3), {20, 18, 16}, EmissionSide::back);
  add_lamp(scene, SphereSet{"bulb", {{{2, 1, 0}, 0.2f}}}, {5, 5, 5}, EmissionSide::front);
  std::vector<Shape> shapes = scene.geometry->shapes();
  shapes.push_back(std::move(leaf));
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  scene.materials.push_back({"leaf", Lambert{{0.2f, 0.7f, 0.1f}}});
  scene.bindings.push_back({std::uint32_t(scene.materials.size() - 1)});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.2f;
  if (is_cut_out) set_alpha(scene, std::uint32_t(scene.bindings.size() - 1), leaf_alpha());
  return scene;
}

/// A floor under a square lamp; the camera sees the floor alone.
Scene lamp_scene() {
  Scene scene = scene_of(floor_square(2, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 2}, {0, 0, 0});
  add_lamp(scene, floor_square(0.5f, 1.5f), {4, 4, 4}, EmissionSide::both);
  return scene;
}

/// Everything about alpha at once: on surfaces, balls and emitters.
Scene scene_of_holes() {
  Scene scene = scene_of(soup(60, 0.7f, 3), {0.8f, 0.7f, 0.3f}, {0, 0.3f, 1.6f}, {0, 0, 0});
  add_lamp(scene, floor_square(0.5f, 1.2f), {3, 2, 1}, EmissionSide::both);
  add_lamp(scene, floor_square(0.5f, -1.2f), {1, 2, 3}, EmissionSide::front);
  add_lamp(scene, SphereSet{"ball", {{{0.3f, 0.8f, 0.4f}, 0.2f}}}, {2, 2, 2}, EmissionSide::front);
  add_lamp(scene, SphereSet{"unseen", {{{-0.4f, 0.5f, 0.4f}, 0.2f}}}, {1, 1, 3}, EmissionSide::front);
  add_light(scene, PointLight{{0.3f, 0.2f, 0.1f}, {1, 2, 3}, {}});
  add_light(scene, AmbientLight{{0, 1, 0}, {0.1f, 0.2f, 0.1f}});
  for (std::uint32_t shape = 0; shape < 4; ++shape) set_alpha(scene, shape, random_alpha(shape));
  set_alpha(scene, 4, constant_alpha(0));
  scene.materials[0].model = CoatedDiffuse{.roughness = {0.4f, 0.4f}};
  return scene;
}

}  // namespace

TEST_CASE("a leaf cut out of a square looks like a leaf of triangles, and throws its shadow") {
  const Scene cut = leaf_scene(leaf_square(0), true), real = leaf_scene(leaf_mesh(0), false);
  const Scene whole = leaf_scene(leaf_square(0), false);
  for (const DirectMethod method : all_methods) {
    const PathOptions path{.max_depth = 3, .direct = method};
    const Estimate expected = estimate(real, path, small_picture(4096));
    // The same paths but for the rounding of their vertices: far closer than by chance.
    CHECK(estimate(cut, path, small_picture(4096)).mean == Approx(expected.mean).epsilon(1e-3));
    // The square without its holes is something else.
    CHECK(std::fabs(estimate(whole, path, small_picture(4096)).mean / expected.mean - 1) > 0.15);
  }
}

TEST_CASE("of a surface of alpha a the background is seen by 1 - a") {
  Scene scene = scene_of(floor_square(5, 0), {0, 0, 0}, {0, 2, 0}, {0, 0, 0});
  Image map(1, 1);
  map.pixels[0] = {2, 2, 2};
  add_light(scene, EnvironmentLight{std::make_shared<const Image>(std::move(map))});
  set_alpha(scene, 0, constant_alpha(0.3f));
  check_mean(estimate(scene, {.max_depth = 1}, small_picture(10000)), 0.7 * 2, 0.02);
}

TEST_CASE("an emitter of alpha a emits this part of its light, by every way of finding it") {
  for (const DirectMethod method : all_methods) {
    const PathOptions path{.max_depth = 1, .direct = method};
    Scene scene = lamp_scene();
    const Estimate full = estimate(scene, path, small_picture(20000));
    set_alpha(scene, 1, constant_alpha(0.25f));
    Estimate part = estimate(scene, path, small_picture(40000));
    part.mean *= 4, part.standard_error *= 4;
    check_same_mean(part, full, 0.15);
  }
  // Seen from below, it is so bright itself.
  Scene scene = lamp_scene();
  scene.camera = camera_at({0, 1, 0}, {0, 2, 0});
  set_alpha(scene, 1, constant_alpha(0.25f));
  check_mean(estimate(scene, {.max_depth = 0}, small_picture(10000)), 0.25 * 4, 0.05);
}

TEST_CASE("a lamp with holes by points of the scene emits from what is left, by every way of finding it") {
  // Two opposite quarters of the lamp are there.
  Scene scene = lamp_scene();
  const PathOptions by_lights{.max_depth = 1, .direct = DirectMethod::lights};
  const Estimate full = estimate(scene, by_lights, small_picture(5000));
  scene.textures = {constant_alpha(1), constant_alpha(0)};
  set_alpha(scene, 1, {"cubes", CubesTexture{0, 1}});
  for (const DirectMethod method : all_methods) {
    Estimate part = estimate(scene, {.max_depth = 1, .direct = method}, small_picture(20000));
    part.mean *= 2, part.standard_error *= 2;
    check_same_mean(part, full, 0.15);
  }
}

TEST_CASE("a ball that emits with holes is as bright by every way of finding its light") {
  Scene scene = scene_of(floor_square(2, 0), {0.5f, 0.5f, 0.5f}, {0, 1, 2}, {0, 0, 0});
  add_lamp(scene, SphereSet{"ball", {{{0, 1, 0}, 0.3f}}}, {4, 4, 4}, EmissionSide::front);
  set_alpha(scene, 1, random_alpha(8));
  const auto found = [&](DirectMethod method) {
    return estimate(scene, {.max_depth = 1, .direct = method}, small_picture(40000));
  };
  const Estimate expected = found(DirectMethod::lights);
  check_same_mean(found(DirectMethod::mis), expected, 0.1);
  check_same_mean(found(DirectMethod::hemisphere), expected, 0.1);
}

TEST_CASE("an emitter of alpha 0 is not seen, and emits all its light") {
  for (const DirectMethod method : {DirectMethod::mis, DirectMethod::lights}) {
    const PathOptions path{.max_depth = 1, .direct = method};
    Scene scene = lamp_scene();
    const Estimate full = estimate(scene, path, small_picture(20000));
    set_alpha(scene, 1, constant_alpha(0));
    check_same_mean(estimate(scene, path, small_picture(20000)), full, 0.1);
    scene.camera = camera_at({0, 1, 0}, {0, 2, 0});
    CHECK(estimate(scene, path, small_picture(16)).mean == 0);
  }
}

TEST_CASE("no ray is traced to find an emitter of alpha 0") {
  // Just below a lamp, where rays are to find it.
  Scene scene = scene_of(floor_square(2, 0), {0.5f, 0.5f, 0.5f}, {0, 0.15f, 2}, {0, 0, 0});
  scene.camera.tan_half_width = scene.camera.tan_half_height = 0.01f;
  add_lamp(scene, floor_square(0.5f, 0.3f), {4, 4, 4}, EmissionSide::both);
  const auto bounces = [&] {
    const PathReference integrator(scene, {.max_depth = 1});
    return render_with(scene, integrator, small_picture(16)).rays.bounce;
  };
  const std::uint64_t seen = bounces();
  set_alpha(scene, 1, constant_alpha(0));
  CHECK(seen > 0);
  CHECK(bounces() == 0);
}

TEST_CASE("waves have the reference's bits where shapes have holes, on every engine") {
  check_waves(scene_of_holes());
}

}  // namespace twinray::test
