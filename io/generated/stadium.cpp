// SPDX-License-Identifier: Apache-2.0
// Stands around a field: seats in rows that rise outward, all instances of three seats, the stands' left half
// the mirror of their right one. Large, long and thin instances (steps, rails) lie among small ones.
#include <cmath>

#include "core/elementary.h"
#include "io/generated/generated.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/scene_maker.h"
#include "io/generated/sky.h"

namespace twinray::generated {
namespace {

constexpr int kinds_of_seats = 3;
constexpr float first_row = 40, row_depth = 0.9f, row_rise = 0.45f, seat_width = 0.6f;
constexpr double turns_of_quarter = 0.25;

/// A shell of a back and a seat, on a foot.
Mesh make_seat(int kind) {
  Mesh seat{.name = "seat"};
  const float bend = 0.04f + 0.03f * float(kind);
  add_surface(seat, 10, 16, [&](float u, float v) {
    const float across = (u - 0.5f) * 0.46f, dip = bend * (1 - 4 * (u - 0.5f) * (u - 0.5f));
    return v < 0.5f ? Vec3{across, 0.42f - dip, 0.9f * v - 0.2f}
                    : Vec3{across, 0.42f + 0.9f * (v - 0.5f), 0.25f + dip};
  });
  add_tube(seat, {{0, 0, 0}, {0, 0.42f, 0}, 0.04f, 0.03f, 12, 2});
  return seat;
}

Mesh make_box(const char* name) {
  Mesh box{.name = name};
  add_box(box, {{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}});
  return box;
}

/// Where a seat of a row stands; `part` in [0, 1) runs around the right half.
Transform stand_at(int row, float part, bool is_mirrored) {
  const float radius = first_row + row_depth * float(row);
  const SinCos turn = sincos_turns(0.5f * part - float(turns_of_quarter));
  const Transform mirror = Transform::scaling(is_mirrored ? -1 : 1, 1, 1);
  const Transform outward = Transform::rotation({0, 1, 0}, 90 - 180.0 * (double(part) - 0.5));
  return mirror * Transform::translation(turn.cos * radius, row_rise * float(row), turn.sin * radius * 0.7f) *
         outward;
}

/// Both halves: the seats of a row, and below them steps of one stretched box.
std::size_t add_row(SceneMaker& scene, int row, std::size_t seats) {
  const std::uint32_t box = kinds_of_seats;
  for (std::size_t i = 0; i < seats; ++i) {
    const float part = (float(i) + 0.5f) / float(seats);
    for (const bool is_mirrored : {false, true}) {
      const Transform place = stand_at(row, part, is_mirrored);
      scene.add_instance(std::uint32_t((i + std::size_t(row)) % kinds_of_seats), place);
      if (i % 8 == 0)
        scene.add_instance(box, place * Transform::translation(0, -0.1, 0) * Transform::scaling(5, 0.2, 0.9));
    }
  }
  return 2 * (seats + (seats + 7) / 8);
}

}  // namespace

Scene make_stadium(std::size_t instances) {
  check_count("stadium", instances);
  SceneMaker scene;
  Mesh field{.name = "field"};
  add_surface(field, 40, 40, [](float u, float v) {
    return Vec3{140 * (u - 0.5f), -0.2f, 140 * (0.5f - v)};
  });
  scene.add(std::move(field), Rgb{0.15f, 0.4f, 0.1f});
  const Rgb colors[kinds_of_seats] = {{0.7f, 0.1f, 0.08f}, {0.8f, 0.75f, 0.7f}, {0.1f, 0.2f, 0.6f}};
  for (int kind = 0; kind < kinds_of_seats; ++kind) {
    scene.begin_prototype();
    scene.add(make_seat(kind), colors[kind]);
  }
  scene.begin_prototype();
  scene.add(make_box("step"), Rgb{0.5f, 0.5f, 0.52f});
  std::size_t left = instances;
  for (int row = 0; left > 0; ++row) {
    const float length = 3.14159265f * (first_row + row_depth * float(row));
    left -= std::min(left, add_row(scene, row, std::min(left, std::size_t(length / seat_width))));
  }
  scene.add_light("sky", make_sky());
  scene.add_light("sun", DirectionalLight{normalize(Vec3{-0.3f, -0.8f, -0.4f}), {3, 2.8f, 2.4f}});
  return scene.finish(camera_of({{0, 9, 38}, {0, 4, -30}, 0.75f}));
}

}  // namespace twinray::generated
