// SPDX-License-Identifier: Apache-2.0
#include "io/generated/trees.h"

#include <cmath>

#include "core/elementary.h"
#include "io/generated/mesh_parts.h"

namespace twinray::generated {
namespace {

/// A tree of 3000 leaves has leaves of this length.
constexpr float leaf_length = 0.2f;

/// Two triangles, folded a little along the middle.
void add_leaf(Trees& trees, const Vec3& stem, float size) {
  const Vec3 along = normalize(trees.random.in_ball());
  const Vec3 other = trees.random.in_ball();
  const Vec3 across = cross(along, other);
  const float width = length(across);
  if (!(width > 0.01f)) return add_leaf(trees, stem, size);
  const Vec3 side = across * (0.3f * size / width);
  const Vec3 lifted = stem + along * (0.5f * size) + cross(side, along) * 0.3f;
  add_quad(trees.leaves, stem, lifted - side, stem + along * size, lifted + side);
}

}  // namespace

void add_tree(Trees& trees, const Vec3& foot) {
  Random& random = trees.random;
  const float height = random.uniform(6, 11);
  const float girth = 0.022f * height;
  const float lean = random.uniform(-0.05f, 0.05f);
  const Vec3 top = foot + Vec3{lean * height, height, -lean * height};
  add_tube(trees.wood, {foot - Vec3{0, 0.3f, 0}, top, girth, 0.2f * girth, 6, 6});
  Vec3 from[branches], to[branches];
  for (int i = 0; i < branches; ++i) {
    const float where = 0.35f + 0.6f * (float(i) + random.unit()) / float(branches);
    const SinCos turn = sincos_turns(random.unit());
    const float reach = 0.36f * height * (1.15f - where);
    from[i] = foot + (top - foot) * where;
    to[i] = from[i] + Vec3{turn.cos * reach, 0.45f * reach, turn.sin * reach};
    add_tube(trees.wood, {from[i], to[i], 0.35f * girth, 0.05f * girth, 4, 2});
  }
  const float size = leaf_length * std::sqrt(3000.0f / float(trees.leaves_of_tree));
  for (std::size_t i = 0; i < trees.leaves_of_tree; ++i) {
    const int branch = random.below(branches);
    const float where = random.uniform(0.35f, 1.05f);
    const Vec3 shift = random.in_ball() * (0.11f * height);
    add_leaf(trees, from[branch] + (to[branch] - from[branch]) * where + shift, size);
  }
}

}  // namespace twinray::generated
