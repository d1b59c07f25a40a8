// SPDX-License-Identifier: Apache-2.0
#include "io/generated/furniture.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/random.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/noise.h"

namespace twinray::generated {
namespace {

constexpr Rgb oak{0.5f, 0.33f, 0.18f};
constexpr Rgb walnut{0.28f, 0.17f, 0.1f};

/// A box that stands on `foot` (the middle of its lower side).
Aabb standing(const Vec3& foot, const Vec3& size) {
  const Vec3 half{0.5f * size.x, 0, 0.5f * size.z};
  return {foot - half, foot + Vec3{half.x, size.y, half.z}};
}

/// A leg in three parts, thick in the middle.
void add_leg(Mesh& mesh, const Vec3& foot, const Vec3& head, float radius, int sides) {
  const Vec3 a = foot + (head - foot) * 0.3f, b = foot + (head - foot) * 0.8f;
  add_tube(mesh, {foot, a, 0.6f * radius, radius, sides, 4});
  add_tube(mesh, {a, b, radius, 0.8f * radius, sides, 4});
  add_tube(mesh, {b, head, 0.8f * radius, 1.1f * radius, sides, 2});
}

void add_tubes(Mesh& mesh, const Mesh& part, const Transform& place) {
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  for (const Vec3& p : part.positions) mesh.positions.push_back(place.point(p));
  for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}

/// A chair at the origin that faces -z.
Mesh chair() {
  Mesh mesh;
  add_box(mesh, standing({0, 0.44f, 0}, {0.44f, 0.035f, 0.44f}));
  for (const float x : {-0.18f, 0.18f}) {
    add_leg(mesh, {1.1f * x, 0, -0.2f}, {x, 0.44f, -0.18f}, 0.02f, 10);
    add_leg(mesh, {1.1f * x, 0, 0.22f}, {x, 0.44f, 0.19f}, 0.02f, 10);
    add_tube(mesh, {{x, 0.2f, -0.19f}, {x, 0.22f, 0.2f}, 0.01f, 0.01f, 8, 2});
    add_tube(mesh, {{1.1f * x, 0.46f, 0.2f}, {1.15f * x, 1.0f, 0.29f}, 0.016f, 0.012f, 10, 4});
  }
  for (int i = 0; i < 7; ++i) {
    const float x = 0.045f * float(i - 3);
    add_tube(mesh, {{x, 0.47f, 0.2f}, {1.15f * x, 0.95f, 0.28f}, 0.007f, 0.005f, 8, 8});
  }
  add_box(mesh, standing({0, 0.95f, 0.285f}, {0.46f, 0.07f, 0.022f}));
  return mesh;
}

/// As many squares along a cube's edge as make about `triangles` of `balls`; 2 at least.
int squares_of_ball(std::size_t triangles, int balls) {
  return std::max(2, int(std::sqrt(double(triangles) / (12.0 * balls))));
}

void add_fruit(SceneMaker& scene, std::size_t triangles) {
  constexpr int count = 12;
  const int n = squares_of_ball(triangles, count);
  Random random(21);
  Mesh oranges{.name = "oranges"}, apples{.name = "apples"};
  for (int i = 0; i < count; ++i) {
    const SinCos turn = sincos_turns(float(i % 6) / 6 + 0.08f * random.unit());
    const float ring = i < 6 ? 0.13f : 0.06f;
    const Vec3 at = table_center + Vec3{ring * turn.cos, i < 6 ? 0.11f : 0.19f, ring * turn.sin};
    const unsigned seed = unsigned(i);
    add_ball(i % 2 ? apples : oranges, at, n, [&](const Vec3& p) {
      return 0.055f + 0.003f * noise(p * 2, seed) + 0.0006f * noise(p * 25, seed);
    });
  }
  scene.add(std::move(oranges), Rgb{0.85f, 0.42f, 0.08f});
  scene.add(std::move(apples), Rgb{0.6f, 0.1f, 0.08f});
  Mesh bowl{.name = "bowl"};
  add_surface(bowl, 48, 12, [](float u, float v) {
    const SinCos turn = sincos_turns(u < 1 ? u : 0);
    const float radius = 0.05f + 0.17f * v;
    return table_center + Vec3{radius * turn.cos, 0.035f + 0.09f * v * v, radius * turn.sin};
  });
  scene.add(std::move(bowl), Rgb{0.75f, 0.78f, 0.8f});
}

void add_chandelier(SceneMaker& scene, std::size_t triangles) {
  constexpr int rings = 4, per_ring = 20;
  const int n = squares_of_ball(triangles, rings * per_ring);
  const Vec3 middle{table_center.x, 1.95f, table_center.z};
  Mesh balls{.name = "chandelier"}, wires{.name = "wires"};
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < per_ring; ++i) {
      const SinCos turn = sincos_turns((float(i) + 0.5f * float(ring % 2)) / float(per_ring));
      const float radius = 0.42f - 0.09f * float(ring);
      const Vec3 at = middle + Vec3{radius * turn.cos, -0.08f * float(ring), radius * turn.sin};
      add_ball(balls, at, n, 0.035f);
      add_tube(wires, {at, {at.x, 2.79f, at.z}, 0.0008f, 0.0008f, 3, 1});
    }
  scene.add(std::move(balls), Microfacet{.alpha = 0.3f});
  scene.add(std::move(wires), Rgb{0.2f, 0.2f, 0.2f});
}

void add_cushions(SceneMaker& scene, std::size_t triangles) {
  constexpr int count = 5;
  const int n = squares_of_ball(triangles, count);
  Mesh cushions{.name = "cushions"};
  for (int i = 0; i < count; ++i) {
    const bool is_seat = i < 3;
    const Vec3 at = is_seat ? Vec3{2.45f, 0.47f, 0.75f * float(i) + 0.6f}
                            : Vec3{2.6f, 0.76f, 1.3f * float(i - 3) + 0.75f};
    const Vec3 half = is_seat ? Vec3{0.42f, 0.12f, 0.37f} : Vec3{0.1f, 0.22f, 0.25f};
    const unsigned seed = 40 + unsigned(i);
    // A superellipsoid: the sum of the fourth powers is 1.
    add_ball(cushions, at, n, [&](const Vec3& p) {
      const Vec3 q{p.x / half.x, p.y / half.y, p.z / half.z};
      const float sum = q.x * q.x * q.x * q.x + q.y * q.y * q.y * q.y + q.z * q.z * q.z * q.z;
      return (1 + 0.03f * fractal_noise(p * 6, 4, seed)) / std::sqrt(std::sqrt(sum));
    });
  }
  scene.add(std::move(cushions), Rgb{0.2f, 0.3f, 0.42f});
}

void add_books(Mesh (&books)[3], float x, float y, float end, Random& random) {
  while (x < end - 0.06f) {
    const float width = random.uniform(0.012f, 0.05f);
    const float height = random.uniform(0.17f, 0.27f);
    const float depth = random.uniform(0.12f, 0.2f);
    const float lean = random.below(6) == 0 ? random.uniform(2, 6) : 0;
    const Transform place =
        Transform::translation(x, y, -3.78) * Transform::rotation({0, 0, 1}, double(lean));
    Mesh& mesh = books[random.below(3)];
    add_box(mesh, {{0, 0, 0}, {width, height, depth}}, place);
    x += width + 0.001f + 0.004f * lean;
  }
}

}  // namespace

void add_dining_group(SceneMaker& scene) {
  Mesh table{.name = "table"};
  add_box(table, standing(table_center - Vec3{0, 0.04f, 0}, {2 * table_half_x, 0.04f, 2 * table_half_z}));
  for (const float x : {-0.85f, 0.85f})
    for (const float z : {-0.38f, 0.38f}) {
      const Vec3 foot{table_center.x + x, 0, table_center.z + z};
      add_leg(table, foot, foot + Vec3{0, 0.71f, 0}, 0.035f, 16);
    }
  scene.add(std::move(table), oak);

  Mesh chairs{.name = "chairs"};
  const Mesh one = chair();
  struct Place {
    float x, z;
    double turn;
  };
  for (const auto& [x, z, turn] :
       {Place{-0.5f, 0.75f, 4}, Place{0.45f, 0.82f, -11}, Place{-0.45f, -0.75f, 178},
        Place{0.5f, -0.78f, 186}, Place{-1.35f, 0, 265}, Place{1.4f, 0.05f, 83}})
    add_tubes(chairs, one,
              Transform::translation(table_center.x + x, 0, table_center.z + z) *
                  Transform::rotation({0, 1, 0}, turn));
  scene.add(std::move(chairs), oak);
}

void add_bookcase(SceneMaker& scene) {
  constexpr float left = -1.6f, right = 2.6f;
  constexpr int shelves = 7;
  Mesh frame{.name = "bookcase"};
  Mesh books[3] = {{.name = "red books"}, {.name = "green books"}, {.name = "grey books"}};
  Random random(31);
  for (int i = 0; i <= shelves; ++i) {
    const float y = 0.08f + 0.33f * float(i);
    add_box(frame, {{left, y - 0.02f, -3.8f}, {right, y, -3.55f}});
    if (i == shelves) break;
    for (int part = 0; part < 4; ++part) {
      const float begin = left + (right - left) * 0.25f * float(part);
      add_books(books, begin + 0.03f, y, begin + random.uniform(0.7f, 1.0f) * (right - left) / 4, random);
    }
  }
  for (int part = 0; part <= 4; ++part) {
    const float x = left + (right - left) * 0.25f * float(part);
    add_box(frame, {{x - 0.012f, 0, -3.8f}, {x + 0.012f, 2.41f, -3.55f}});
  }
  scene.add(std::move(frame), walnut);
  constexpr Rgb colors[3] = {{0.45f, 0.12f, 0.1f}, {0.15f, 0.3f, 0.2f}, {0.55f, 0.52f, 0.45f}};
  for (int i = 0; i < 3; ++i) scene.add(std::move(books[i]), colors[i]);
}

void add_plant(SceneMaker& scene) {
  const Vec3 foot{-2.45f, 0, -3.2f};
  Mesh pot{.name = "pot"};
  add_tube(pot, {foot, foot + Vec3{0, 0.42f, 0}, 0.17f, 0.25f, 48, 8});
  scene.add(std::move(pot), Rgb{0.55f, 0.27f, 0.16f});
  Mesh leaves{.name = "plant"};
  Random random(51);
  for (int i = 0; i < 90; ++i) {
    const SinCos turn = sincos_turns(random.unit());
    const float reach = random.uniform(0.15f, 0.6f);
    const float height = random.uniform(0.7f, 1.5f);
    add_surface(leaves, 2, 14, [&](float u, float v) {
      const float out = 0.08f + reach * v * v;
      const float across = 0.03f * (u - 0.5f) * (1 - 0.95f * v * v);
      return foot + Vec3{out * turn.cos - across * turn.sin, 0.38f + height * v * (1.25f - 0.6f * v * reach),
                         out * turn.sin + across * turn.cos};
    });
  }
  scene.add(std::move(leaves), Rgb{0.16f, 0.38f, 0.12f});
}

void add_sofa(SceneMaker& scene) {
  Mesh sofa{.name = "sofa"};
  add_box(sofa, {{2.05f, 0.1f, 0.2f}, {2.95f, 0.36f, 2.5f}});
  add_box(sofa, {{2.75f, 0.1f, 0.2f}, {2.95f, 0.85f, 2.5f}});
  for (const float z : {0.05f, 2.5f}) add_box(sofa, {{2.0f, 0.1f, z}, {2.95f, 0.6f, z + 0.15f}});
  for (const float x : {2.1f, 2.85f})
    for (const float z : {0.15f, 2.55f}) add_tube(sofa, {{x, 0, z}, {x, 0.1f, z}, 0.02f, 0.025f, 12, 1});
  scene.add(std::move(sofa), Rgb{0.3f, 0.38f, 0.45f});
}

void add_round_things(SceneMaker& scene, const RoundThings& triangles) {
  add_fruit(scene, triangles.fruit);
  add_chandelier(scene, triangles.chandelier);
  add_cushions(scene, triangles.cushions);
}

}  // namespace twinray::generated
