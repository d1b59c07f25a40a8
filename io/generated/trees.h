// SPDX-License-Identifier: Apache-2.0
// Trees with a trunk, branches, and leaves scattered around the branches.
#pragma once
#include <cstddef>

#include "core/geometry.h"
#include "core/random.h"

namespace twinray::generated {

inline constexpr int branches = 9;

/// Trees while they are made: all of one random sequence.
struct Trees {
  Random random;
  std::size_t leaves_of_tree;  ///< They cover the same area, however many they are.
  Mesh wood{.name = "wood"}, leaves{.name = "leaves"};
};

/// A tree of 6 to 11 m.
void add_tree(Trees& trees, const Vec3& foot);

}  // namespace twinray::generated
