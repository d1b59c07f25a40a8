// SPDX-License-Identifier: Apache-2.0
// A dozen plants, each stored once, and a wood of as many instances of them as is asked for: turned, scaled,
// and every other one mirrored.
#include <cmath>

#include "io/generated/generated.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/noise.h"
#include "io/generated/scene_maker.h"
#include "io/generated/sky.h"
#include "io/generated/trees.h"

namespace twinray::generated {
namespace {

constexpr unsigned woods_seed = 17;
constexpr int kinds_of_trees = 8, kinds_of_tufts = 4;
constexpr std::size_t leaves_of_tree = 5000;
constexpr int blades_of_tuft = 600;
constexpr float plant_spacing = 2.2f;

/// A square of trees and tufts, most of it before the camera.
struct WoodsPlan {
  int columns, rows;

  explicit WoodsPlan(std::size_t instances)
      : columns(int(std::ceil(std::sqrt(double(instances))))),
        rows(int((instances + std::size_t(columns) - 1) / std::size_t(columns))) {}
  float half_width() const { return 0.5f * plant_spacing * float(columns); }
  float depth() const { return plant_spacing * float(rows); }
};

Mesh make_tuft(Random& random) {
  Mesh tuft{.name = "tuft"};
  for (int i = 0; i < blades_of_tuft; ++i) {
    const Vec3 around = random.in_ball();
    const Vec3 root{0.5f * around.x, -0.05f, 0.5f * around.z};
    const Vec3 side = random.in_ball() * 0.02f, bend = random.in_cube(0.15f);
    const float height = random.uniform(0.2f, 0.7f);
    add_triangle(tuft, root - Vec3{side.x, 0, side.z}, root + Vec3{side.x + 0.01f, 0, side.z},
                 root + Vec3{bend.x, height, bend.z});
  }
  return tuft;
}

void add_ground(SceneMaker& scene, const WoodsPlan& plan) {
  Mesh ground{.name = "ground"};
  const float half = plan.half_width() + 12, front = 14, back = plan.depth() + 12;
  add_surface(ground, 120, 120, [&](float u, float v) {
    const float x = half * (2 * u - 1), z = front - (front + back) * v;
    return Vec3{x, ground_height(x, z, woods_seed), z};
  });
  scene.add(std::move(ground), Rgb{0.28f, 0.2f, 0.12f});
}

/// The prototypes: trees, and tufts of grass behind them.
void add_plants(SceneMaker& scene, Random& random) {
  for (int kind = 0; kind < kinds_of_trees; ++kind) {
    scene.begin_prototype();
    Trees trees{Random(woods_seed, std::uint64_t(kind)), leaves_of_tree};
    add_tree(trees, {0, 0, 0});
    scene.add(std::move(trees.wood), Rgb{0.3f, 0.22f, 0.16f});
    const float yellow = 0.2f + 0.03f * float(kind);
    scene.add(std::move(trees.leaves), Rgb{yellow, 0.45f, 0.1f});
  }
  for (int kind = 0; kind < kinds_of_tufts; ++kind) {
    scene.begin_prototype();
    scene.add(make_tuft(random), Rgb{0.3f, 0.5f - 0.05f * float(kind), 0.12f});
  }
}

/// Every fourth plant is a tree.
void add_instances(SceneMaker& scene, Random& random, const WoodsPlan& plan, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = float(i % std::size_t(plan.columns)), row = float(i / std::size_t(plan.columns));
    const float dx = random.unit(), dz = random.unit(), size = random.uniform(0.6f, 1.3f);
    const float x = (column + dx) * plant_spacing - plan.half_width(), z = -(row + dz) * plant_spacing;
    const int kind =
        i % 4 == 0 ? random.below(kinds_of_trees) : kinds_of_trees + random.below(kinds_of_tufts);
    const double mirror = i % 2 ? -1 : 1;
    const Transform turn = Transform::rotation({0, 1, 0}, 360.0 * random.unit());
    scene.add_instance(std::uint32_t(kind), Transform::translation(x, ground_height(x, z, woods_seed), z) *
                                                turn * Transform::scaling(mirror * size, size, size));
  }
}

}  // namespace

Scene make_woods(std::size_t instances) {
  check_count("woods", instances);
  const WoodsPlan plan(instances);
  Random random(woods_seed);
  SceneMaker scene;
  add_ground(scene, plan);
  add_plants(scene, random);
  add_instances(scene, random, plan, instances);
  scene.add_light("sky", make_sky());
  scene.add_light("sun", DirectionalLight{normalize(Vec3{-0.6f, -0.7f, -0.5f}), {3.5f, 3.2f, 2.6f}});
  return scene.finish(camera_of({{0.5f, 2.6f, 9}, {0, 3.4f, -6}, 0.7f}));
}

}  // namespace twinray::generated
