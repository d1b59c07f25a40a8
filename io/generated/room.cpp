// SPDX-License-Identifier: Apache-2.0
// The shell of the room, and how the triangles are divided: the shell and the wooden things have a fixed
// number, cloth, curtains and round things get shares of the rest, and the rug's pile is what remains.
#include "io/generated/generated.h"

#include "core/random.h"
#include "io/generated/fabrics.h"
#include "io/generated/furniture.h"
#include "io/generated/mesh_parts.h"
#include "io/generated/scene_maker.h"

namespace twinray::generated {
namespace {

// The room is x in [-3, 3], y in [0, 2.8], z in [-4, 4]; behind the wall at x = -3 lies a shaft of light.
constexpr float shaft_x = -4.2f, wall_x = -3.2f, inside_x = -3, end_x = 3, room_height = 2.8f, end_z = 4;
constexpr float window_low = 0.85f, window_high = 2.35f;
struct Span {
  float begin, end;
};
constexpr Span windows[] = {{-2.3f, -0.2f}, {0.5f, 2.5f}};

void add_shell(SceneMaker& scene) {
  Mesh walls{.name = "walls"};
  add_quad(walls, {shaft_x, room_height, -end_z}, {end_x, room_height, -end_z}, {end_x, room_height, end_z},
           {shaft_x, room_height, end_z});
  add_quad(walls, {shaft_x, 0, -end_z}, {end_x, 0, -end_z}, {end_x, room_height, -end_z},
           {shaft_x, room_height, -end_z});
  add_quad(walls, {shaft_x, 0, end_z}, {shaft_x, room_height, end_z}, {end_x, room_height, end_z},
           {end_x, 0, end_z});
  add_quad(walls, {end_x, 0, -end_z}, {end_x, 0, end_z}, {end_x, room_height, end_z},
           {end_x, room_height, -end_z});
  add_quad(walls, {shaft_x, 0, -end_z}, {shaft_x, room_height, -end_z}, {shaft_x, room_height, end_z},
           {shaft_x, 0, end_z});
  add_box(walls, {{wall_x, 0, -end_z}, {inside_x, window_low, end_z}});
  add_box(walls, {{wall_x, window_high, -end_z}, {inside_x, room_height, end_z}});
  float begin = -end_z;
  for (const Span& window : windows) {
    add_box(walls, {{wall_x, window_low, begin}, {inside_x, window_high, window.begin}});
    begin = window.end;
  }
  add_box(walls, {{wall_x, window_low, begin}, {inside_x, window_high, end_z}});
  scene.add(std::move(walls), Rgb{0.74f, 0.72f, 0.67f});
  Mesh ground{.name = "ground"};
  add_quad(ground, {shaft_x, 0, -end_z}, {shaft_x, 0, end_z}, {end_x, 0, end_z}, {end_x, 0, -end_z});
  scene.add(std::move(ground), Rgb{0.2f, 0.15f, 0.1f});
}

/// Boards a hand wide and metres long, with a gap of a millimetre.
void add_boards(SceneMaker& scene) {
  constexpr float width = 0.12f, gap = 0.001f, thickness = 0.003f;
  Random random(81);
  Mesh light{.name = "light boards"}, dark{.name = "dark boards"};
  for (float x = inside_x; x < end_x - gap; x += width) {
    float z = -end_z - random.uniform(0, 2);
    while (z < end_z) {
      const float length = random.uniform(1.6f, 3.2f);
      const float begin = std::max(z, -end_z), end = std::min(z + length - gap, end_z);
      if (end > begin)
        add_box(random.below(2) ? light : dark,
                {{x, 0, begin}, {std::min(x + width - gap, end_x), thickness, end}});
      z += length;
    }
  }
  scene.add(std::move(light), Rgb{0.52f, 0.36f, 0.22f});
  scene.add(std::move(dark), Rgb{0.44f, 0.29f, 0.17f});
}

void add_beams(SceneMaker& scene) {
  Mesh beams{.name = "beams"};
  for (const float z : {-3.2f, -1.9f, 0.5f, 1.8f, 3.1f})
    add_box(beams, {{inside_x, room_height - 0.14f, z - 0.06f}, {end_x, room_height, z + 0.06f}});
  scene.add(std::move(beams), Rgb{0.35f, 0.23f, 0.14f});
}

void add_blinds(SceneMaker& scene) {
  constexpr int count = 46;
  Mesh slats{.name = "slats"}, cords{.name = "cords"};
  for (const Span& window : windows) {
    for (int i = 0; i < count; ++i) {
      const float y = window_low + (window_high - window_low) * (float(i) + 0.5f) / float(count);
      add_box(slats, {{-0.02f, -0.0006f, window.begin + 0.01f}, {0.02f, 0.0006f, window.end - 0.01f}},
              Transform::translation(-3.04, double(y), 0) * Transform::rotation({0, 0, 1}, -38));
    }
    for (const float part : {0.15f, 0.5f, 0.85f}) {
      const float z = window.begin + part * (window.end - window.begin);
      add_tube(cords, {{-3.04f, window_low, z}, {-3.04f, window_high, z}, 0.001f, 0.001f, 5, 1});
    }
  }
  scene.add(std::move(slats), Rgb{0.82f, 0.8f, 0.74f});
  scene.add(std::move(cords), Rgb{0.6f, 0.6f, 0.6f});
}

void add_lamps(SceneMaker& scene) {
  Mesh daylight{.name = "daylight"};
  const float x = shaft_x + 0.05f;
  add_quad(daylight, {x, 0.3f, 3.6f}, {x, 0.3f, -3.6f}, {x, 2.7f, -3.6f}, {x, 2.7f, 3.6f});
  scene.add_lamp(std::move(daylight), {9, 10, 11});
  Mesh lamp{.name = "lamp"};
  const float y = 2.795f, half = 0.35f;
  const Vec3 c = table_center;
  add_quad(lamp, {c.x - half, y, c.z - half}, {c.x + half, y, c.z - half}, {c.x + half, y, c.z + half},
           {c.x - half, y, c.z + half});
  scene.add_lamp(std::move(lamp), {30, 24, 16});
}

}  // namespace

Scene make_room(std::size_t triangles) {
  check_size("room", triangles, least_room);
  SceneMaker scene;
  add_shell(scene);
  add_boards(scene);
  add_beams(scene);
  add_blinds(scene);
  add_lamps(scene);
  add_dining_group(scene);
  add_bookcase(scene);
  add_plant(scene);
  add_sofa(scene);
  const std::size_t rest = triangles - scene.triangles();
  add_tablecloth(scene, rest / 5);
  add_curtains(scene, rest / 8);
  add_round_things(scene, {.fruit = rest / 8, .chandelier = rest / 8, .cushions = rest / 10});
  add_rug(scene, triangles - scene.triangles());
  return scene.finish(camera_of({{2.5f, 1.6f, 3.8f}, {-0.35f, 0.75f, -0.9f}, 0.85f}));
}

}  // namespace twinray::generated
