// SPDX-License-Identifier: Apache-2.0
// A displaced sphere that floats in a closed box; the camera stands inside too.
#include <cmath>

#include "io/generated/generated.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/noise.h"
#include "io/generated/scene_maker.h"

namespace twinray::generated {
namespace {

constexpr unsigned ball_seed = 5;
/// Noise as fine as the grid itself, at most.
constexpr int most_octaves = 8;

void add_walls(SceneMaker& scene) {
  constexpr float x = 2, y = 1.7f, z = 3;  // Half of the box's sides.
  Mesh white{.name = "walls"};
  add_quad(white, {-x, -y, -z}, {-x, -y, z}, {x, -y, z}, {x, -y, -z});
  add_quad(white, {-x, y, -z}, {x, y, -z}, {x, y, z}, {-x, y, z});
  add_quad(white, {-x, -y, -z}, {x, -y, -z}, {x, y, -z}, {-x, y, -z});
  add_quad(white, {-x, -y, z}, {-x, y, z}, {x, y, z}, {x, -y, z});
  scene.add(std::move(white), Rgb{0.75f, 0.74f, 0.7f});
  Mesh left{.name = "left wall"};
  add_quad(left, {-x, -y, -z}, {-x, y, -z}, {-x, y, z}, {-x, -y, z});
  scene.add(std::move(left), Rgb{0.7f, 0.25f, 0.2f});
  Mesh right{.name = "right wall"};
  add_quad(right, {x, -y, -z}, {x, -y, z}, {x, y, z}, {x, y, -z});
  scene.add(std::move(right), Rgb{0.2f, 0.4f, 0.65f});
  Mesh lamp{.name = "lamp"};
  const float height = y - 0.001f;
  add_quad(lamp, {-0.6f, height, -0.3f}, {0.6f, height, -0.3f}, {0.6f, height, 0.9f}, {-0.6f, height, 0.9f});
  scene.add_lamp(std::move(lamp), {14, 13, 11});
}

}  // namespace

Scene make_ball(std::size_t triangles) {
  check_size("ball", triangles, least_ball);
  SceneMaker scene;
  add_walls(scene);
  const int n = int(std::lround(std::sqrt(double(triangles - scene.triangles()) / 12)));
  int octaves = 1;
  while (octaves < most_octaves && 4 << octaves < n) ++octaves;
  Mesh ball{.name = "ball"};
  add_ball(ball, {0, -0.2f, -0.4f}, n,
           [octaves](const Vec3& p) { return 1 + 0.17f * fractal_noise(p * 2.3f, octaves, ball_seed); });
  scene.add(std::move(ball), Rgb{0.72f, 0.62f, 0.45f});
  return scene.finish(camera_of({{0.3f, 0.2f, 2.8f}, {0, -0.1f, 0}, 0.62f}));
}

}  // namespace twinray::generated
