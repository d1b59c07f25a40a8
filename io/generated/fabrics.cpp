// SPDX-License-Identifier: Apache-2.0
#include "io/generated/fabrics.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/random.h"
#include "io/generated/furniture.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/noise.h"

namespace twinray::generated {
namespace {

/// Sine of any number of turns.
float wave(float turns) { return sincos_turns(turns - std::floor(turns)).sin; }

/// Where the cloth's point (x, z), counted from the middle, comes to lie: what is beyond the edge hangs down
/// in folds that widen.
Vec3 draped(float x, float z) {
  constexpr float thickness = 0.004f, rim = 0.006f;
  const float beyond_x = std::max(std::fabs(x) - table_half_x - rim, 0.0f);
  const float beyond_z = std::max(std::fabs(z) - table_half_z - rim, 0.0f);
  const float hanging = std::sqrt(beyond_x * beyond_x + beyond_z * beyond_z);
  const float on_top_x = std::clamp(x, -table_half_x - rim, table_half_x + rim);
  const float on_top_z = std::clamp(z, -table_half_z - rim, table_half_z + rim);
  Vec3 p =
      table_center + Vec3{on_top_x, thickness + 0.001f * fractal_noise({9 * x, 0, 9 * z}, 5, 61), on_top_z};
  if (hanging == 0) return p;
  const float folds = wave(3.1f * (x + z) + 0.3f * noise({2 * x, 0, 2 * z}, 62));
  const float out = hanging * (0.12f + 0.22f * folds * std::min(1.0f, 3 * hanging));
  const float down = hanging * (1 - 0.06f * (1 + folds));
  const float way_x = std::copysign(beyond_x / hanging, x), way_z = std::copysign(beyond_z / hanging, z);
  return p + Vec3{way_x * std::max(out, 0.002f), -down, way_z * std::max(out, 0.002f)};
}

}  // namespace

void add_tablecloth(SceneMaker& scene, std::size_t triangles) {
  constexpr float overhang = 0.28f;
  constexpr float half_x = table_half_x + overhang, half_z = table_half_z + overhang;
  const int columns = std::max(8, int(std::sqrt(0.5 * double(triangles) * half_x / half_z)));
  const int rows = std::max(8, int(0.5 * double(triangles) / columns));
  Mesh cloth{.name = "tablecloth"};
  add_surface(cloth, columns, rows,
              [&](float u, float v) { return draped((2 * u - 1) * half_x, (2 * v - 1) * half_z); });
  scene.add(std::move(cloth), Rgb{0.8f, 0.76f, 0.68f});
}

void add_curtains(SceneMaker& scene, std::size_t triangles) {
  constexpr int rows = 6, count = 4;
  constexpr float width = 0.42f, top = 2.6f;
  const int columns = std::max(8, int(triangles / (2 * rows * count)));
  Mesh curtains{.name = "curtains"};
  for (const float z : {-2.72f, -0.2f, 0.1f, 2.5f})
    add_surface(curtains, columns, rows, [&](float u, float v) {
      const float narrowing = 1 - 0.25f * v * (1 - v);
      const float fold = 0.05f * wave(7 * u + 0.1f * noise({4 * u, 2 * v, z}, 63)) * (0.6f + 0.4f * v);
      return Vec3{-2.88f + fold, top * (1 - v) + 0.03f * v, z + width * (0.5f + (u - 0.5f) * narrowing)};
    });
  scene.add(std::move(curtains), Rgb{0.55f, 0.2f, 0.18f});
}

void add_rug(SceneMaker& scene, std::size_t triangles) {
  const Vec3 middle{0.6f, 0.004f, 1.9f};
  constexpr float half_x = 1.25f, half_z = 0.85f;
  Mesh rug{.name = "rug"};
  Random random(71);
  for (std::size_t i = 0; i < triangles; ++i) {
    const float x = random.uniform(-half_x, half_x);
    const float z = random.uniform(-half_z, half_z);
    const SinCos turn = sincos_turns(random.unit());
    const float bend = random.uniform(0.005f, 0.03f);
    const float bend_turn = random.unit();
    const SinCos way = sincos_turns(bend_turn);
    const float height = random.uniform(0.03f, 0.055f);
    const Vec3 root = middle + Vec3{x, 0, z}, side{0.0012f * turn.cos, 0, 0.0012f * turn.sin};
    add_triangle(rug, root - side, root + side, root + Vec3{bend * way.cos, height, bend * way.sin});
  }
  scene.add(std::move(rug), Rgb{0.85f, 0.78f, 0.66f});
}

}  // namespace twinray::generated
