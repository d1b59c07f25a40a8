// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/vec.h"

namespace twinray {

/// Weights of a triangle's three corners; their sum is 1.
struct TriangleWeights {
  float a, b, c;
};

/// A point whose weights are all at least so large is as far from the edges as it need be.
inline constexpr float edge_weight = 0x1p-6f;

/// Moves a point that lies closer to an edge than 8 offsets (core/offset.h) to that distance, but by no more
/// than edge_weight of the triangle's height.
TriangleWeights keep_off_edges(const Vec3& a, const Vec3& b, const Vec3& c, const TriangleWeights& weights,
                               float offset);

}  // namespace twinray
