// SPDX-License-Identifier: Apache-2.0
#include "integrators/walk_below.h"

#include <cmath>

#include "accel/accelerator.h"
#include "core/subsurface.h"
#include "core/warp.h"
#include "tests/support/catch.h"
#include "tests/support/meshes.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics.h"

namespace twinray::test {
namespace {

/// A plate from z = -thickness to 0, wide enough that nothing comes out at its sides.
Mesh plate(float thickness, float half) {
  Mesh mesh = box_mesh();
  for (Vec3& p : mesh.positions) p = {p.x * half, p.y * half, (p.z - 1) / 2 * thickness};
  return mesh;
}

struct Walks {
  int back = 0;                          ///< That come out where they went in.
  double up = 0, down = 0, squares = 0;  ///< What comes out above and below, per walk; the squares of `up`.
};

/// Rays begin at some depth. Of light that enters a body evenly from all sides at the origin; red alone.
Walks walks_in(const Scene& scene, const Interior& medium, int count, float depth = 1e-3f) {
  const auto engine = build_accelerator(default_backend(), scene.geometry);
  Tracer tracer(*engine, false);
  Random random(5);
  Walks walks;
  for (int i = 0; i < count; ++i) {
    const Vec3 into = -square_to_cosine_hemisphere(in_square(random));
    const WalkDraws draws(SamplerKind::independent, PathKey({.index = std::uint32_t(i)}), 1);
    const WalkStart start{{.origin = {0, 0, -depth}, .direction = into}, depth / -into.z};
    const auto end = walk_below(tracer, {scene, {medium, 0}, start, {1, 0, 0}, draws});
    if (!end) continue;
    const bool is_up = end->hit.is_miss() || end->ray.direction.z > 0;
    walks.back += end->hit.is_miss();
    (is_up ? walks.up : walks.down) += double(end->left.r) / count;
    if (is_up) walks.squares += double(end->left.r) * double(end->left.r) / count;
  }
  return walks;
}

Interior medium_of(float part, float anisotropy = 0) {
  Interior medium;
  medium.scattering = white * part, medium.absorption = white * (1 - part);
  medium.anisotropy = anisotropy;
  return medium;
}

Scene scene_with(std::vector<Shape> shapes) {
  Scene scene = ball_under_sky(CoatedDiffuse{});
  scene.bindings.assign(shapes.size(), {0});
  scene.geometry = std::make_shared<const Geometry>(std::move(shapes));
  return scene;
}

/// The same plate, by a walk along z alone, with draws of its own: exponential ways, even directions.
Walks walks_along_z(double part, double thickness, int count) {
  Random random(17);
  Walks walks;
  for (int i = 0; i < count; ++i) {
    double z = 0, cosine = -std::sqrt(double(random.unit())), weight = 1;
    for (;;) {
      z += cosine * -std::log(1 - double(random.unit()));
      if (z >= 0 || z <= -thickness) break;
      weight *= part;
      cosine = 2 * double(random.unit()) - 1;
    }
    (z >= 0 ? walks.up : walks.down) += weight / count;
    if (z >= 0) walks.squares += weight * weight / count;
  }
  return walks;
}

}  // namespace

TEST_CASE("a deep body reflects as much as its albedo was asked for") {
  const Scene scene = scene_with({plate(100, 100)});
  for (const float g : {0.0f, 0.6f})
    for (const float r : {0.2f, 0.5f, 0.8f}) {
      CAPTURE(g, r);
      const Walks walks = walks_in(scene, medium_of(single_scattering_albedo(r, g), g), 20000);
      // The fit is within 1 %.
      const double error = std::sqrt(walks.squares / 20000);
      CHECK(std::fabs(walks.up - double(r)) < 0.01 * double(r) + 4 * error);
      CHECK(error < 0.01);
    }
}

TEST_CASE("a plate reflects and lets through what a walk along one axis says") {
  for (const float thickness : {0.5f, 3.0f}) {
    CAPTURE(thickness);
    const Scene scene = scene_with({plate(thickness, 100)});
    constexpr int count = 40000;
    const Walks found = walks_in(scene, medium_of(0.9f), count),
                expected = walks_along_z(0.9, thickness, count);
    CHECK(std::fabs(found.up - expected.up) < 6 * std::sqrt(2 * found.squares / count));
    CHECK(found.down == Approx(expected.down).margin(0.015));
    CHECK(found.down > 0.1);
  }
}

TEST_CASE("what absorbs nothing loses nothing") {
  const Walks walks = walks_in(scene_with({plate(8, 100)}), medium_of(1), 2000);
  CHECK(walks.up + walks.down == Approx(1).epsilon(1e-5));
}

TEST_CASE("surfaces of other materials within a body change nothing, and parts of one body are one") {
  const Walks plain = walks_in(scene_with({plate(3, 100)}), medium_of(0.9f), 20000);
  Scene scene = scene_with({plate(3, 100), SphereSet{"eye", {{{0, 0, -1.5f}, 1.2f}}}});
  scene.materials.push_back({.name = "eye"});
  scene.bindings[1].material = 1;
  const Walks passed = walks_in(scene, medium_of(0.9f), 20000);
  CHECK(passed.up == Approx(plain.up).margin(0.02));
  CHECK(passed.down == Approx(plain.down).margin(0.02));
  // Where the ball is of the body's material, walks come out at its surface.
  scene.bindings[1].material = 0;
  const Walks parted = walks_in(scene, medium_of(0.9f), 20000);
  CHECK(parted.up + parted.down > plain.up + plain.down + 0.1);
}

TEST_CASE("a walk that leaves a body that is not closed does not come out") {
  // Only its top is there.
  Mesh top = plate(3, 100);
  std::erase_if(top.triangles, [&](const Triangle& t) {
    const auto& [a, b, c] = t;
    return top.positions[a].z + top.positions[b].z + top.positions[c].z < -1;
  });
  const Walks walks = walks_in(scene_with({top}), medium_of(0.9f), 2000);
  CHECK(walks.down == 0);
  CHECK(walks.up > 0.3);
}

TEST_CASE("a walk that would be too long comes out where it went in") {
  const Walks walks = walks_in(scene_with({plate(100, 100)}), medium_of(1), 1000);
  CHECK(walks.back > 0);
  CHECK(walks.back < 60);
  CHECK(walks.up + walks.down == Approx(1).epsilon(1e-5));
}

TEST_CASE("the way from a surface to where its rays begin is part of a walk") {
  // Nothing is scattered: what comes out below has gone straight through.
  const Scene scene = scene_with({plate(0.5f, 100)});
  const Walks near = walks_in(scene, medium_of(0), 20000), deep = walks_in(scene, medium_of(0), 20000, 0.4f);
  CHECK(near.down > 0.3);
  CHECK(deep.down == Approx(near.down).margin(0.02));
}

TEST_CASE("a walk in black is absorbed") {
  CHECK(walks_in(scene_with({plate(100, 100)}), medium_of(0), 200).up == 0);
}

TEST_CASE("draws of a walk are those of no vertex of a path, nor of another walk") {
  const PathKey key({.index = 3});
  const auto first = [&](std::uint32_t vertex, std::uint32_t event) {
    return WalkDraws(SamplerKind::independent, key, vertex).at(event).draw_1d(Purpose::medium);
  };
  CHECK(first(1, 0) != first(2, 0));
  CHECK(first(1, 0) != first(1, 1));
  CHECK(first(1, 0) != VertexSampler(SamplerKind::independent, key, 1).draw_1d(Purpose::medium));
  CHECK(first(1, 0) != WalkDraws(SamplerKind::independent, key, 1).at_end().draw_1d(Purpose::medium));
}

}  // namespace twinray::test
