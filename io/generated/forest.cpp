// SPDX-License-Identifier: Apache-2.0
// Trees on rough ground. Each has a trunk, branches, and leaves scattered around the branches; what is left
// of the triangles is grass. With the size of the scene grow both the number of trees and that of each one's
// leaves, about as its square root; the leaves of a tree cover the same area, however many they are.
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/random.h"
#include "io/generated/generated.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/noise.h"
#include "io/generated/scene_maker.h"
#include "io/generated/sky.h"
#include "io/generated/trees.h"

namespace twinray::generated {
namespace {

constexpr unsigned forest_seed = 11;
constexpr float tree_spacing = 4.5f;
constexpr double share_of_leaves = 0.85;  // Of the triangles that are neither wood nor ground.
constexpr double wood_of_tree = 2 * 6 * 6 + 2 * 4 * 2 * branches;  // Triangles.

struct ForestPlan {
  int columns, rows;  ///< Of trees; the first row stands before the camera.
  std::size_t leaves_of_tree;
  float half_width() const { return 0.5f * tree_spacing * float(columns); }
  float depth() const { return tree_spacing * float(rows); }
};

ForestPlan plan_of(std::size_t triangles) {
  const int columns = std::max(3, int(std::sqrt(std::sqrt(double(triangles)) / 6)));
  const int rows = columns + columns / 2;
  const double trees = double(columns * rows);
  const double leaves = share_of_leaves * (0.98 * double(triangles) - wood_of_tree * trees) / 2;
  return {columns, rows, std::size_t(leaves / trees)};
}

struct Forest {
  ForestPlan plan;
  Trees trees;
};

void add_trees(Forest& forest) {
  const ForestPlan& plan = forest.plan;
  for (int row = 0; row < plan.rows; ++row)
    for (int column = 0; column < plan.columns; ++column) {
      const float dx = forest.trees.random.uniform(0.15f, 0.85f);
      const float dz = forest.trees.random.uniform(0.15f, 0.85f);
      const float x = (float(column) + dx) * tree_spacing - plan.half_width();
      const float z = -(float(row) + dz) * tree_spacing;
      add_tree(forest.trees, {x, ground_height(x, z, forest_seed), z});
    }
}

Mesh make_ground(const ForestPlan& plan, std::size_t triangles) {
  Mesh ground{.name = "ground"};
  const int n = std::max(4, int(std::sqrt(0.01 * double(triangles))));
  const float half = plan.half_width() + 12, front = 14, back = plan.depth() + 12;
  add_surface(ground, n, n, [&](float u, float v) {
    const float x = half * (2 * u - 1), z = front - (front + back) * v;
    return Vec3{x, ground_height(x, z, forest_seed), z};
  });
  return ground;
}

/// Blades of one triangle, denser towards the camera.
Mesh make_grass(Forest& forest, std::size_t blades) {
  Mesh grass{.name = "grass"};
  Random& random = forest.trees.random;
  for (std::size_t i = 0; i < blades; ++i) {
    const float near = random.unit();
    const float x = random.uniform(-1, 1) * (forest.plan.half_width() + 2);
    const float z = 9 - (forest.plan.depth() + 9) * near * near;
    const Vec3 root{x, ground_height(x, z, forest_seed) - 0.02f, z};
    const Vec3 side = random.in_ball() * 0.02f;
    const Vec3 bend = random.in_cube(0.12f);
    const float height = random.uniform(0.15f, 0.5f);
    add_triangle(grass, root - Vec3{side.x, 0, side.z}, root + Vec3{side.x + 0.01f, 0, side.z},
                 root + Vec3{bend.x, height, bend.z});
  }
  return grass;
}

}  // namespace

Scene make_forest(std::size_t triangles) {
  check_size("forest", triangles, least_forest);
  const ForestPlan plan = plan_of(triangles);
  Forest forest{plan, {Random(forest_seed), plan.leaves_of_tree}};
  SceneMaker scene;
  scene.add(make_ground(forest.plan, triangles), Rgb{0.28f, 0.2f, 0.12f});
  add_trees(forest);
  scene.add(std::move(forest.trees.wood), Rgb{0.3f, 0.22f, 0.16f});
  scene.add(std::move(forest.trees.leaves), Rgb{0.2f, 0.45f, 0.1f});
  scene.add(make_grass(forest, triangles - scene.triangles()), Rgb{0.3f, 0.5f, 0.12f});
  scene.add_light("sky", make_sky());
  scene.add_light("sun", DirectionalLight{normalize(Vec3{-0.6f, -0.7f, -0.5f}), {3.5f, 3.2f, 2.6f}});
  return scene.finish(camera_of({{0.5f, 2.6f, 9}, {0, 3.4f, -6}, 0.7f}));
}

}  // namespace twinray::generated
