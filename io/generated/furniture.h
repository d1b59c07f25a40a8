// SPDX-License-Identifier: Apache-2.0
// What stands in the room: pieces of a fixed number of triangles, and round ones of any.
#pragma once
#include "core/transform.h"
#include "io/generated/scene_maker.h"

namespace twinray::generated {

/// The table's top: where it is, and half of its size.
inline constexpr Vec3 table_center{0.5f, 0.75f, -0.7f};
inline constexpr float table_half_x = 1.0f, table_half_z = 0.5f;

/// A table with turned legs and, around it, six chairs with spindle backs.
void add_dining_group(SceneMaker& scene);
/// Shelves full of books along the back wall.
void add_bookcase(SceneMaker& scene);
/// A pot with long thin leaves.
void add_plant(SceneMaker& scene);
/// A sofa's frame; its cushions are round things.
void add_sofa(SceneMaker& scene);

/// How many triangles the balls of the room may have, together.
struct RoundThings {
  std::size_t fruit, chandelier, cushions;
};
/// Fruit in a bowl on the table, a lamp of metal balls above it, cushions on the sofa. A few triangles fewer
/// than asked for.
void add_round_things(SceneMaker& scene, const RoundThings& triangles);

}  // namespace twinray::generated
