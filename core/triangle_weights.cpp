// SPDX-License-Identifier: Apache-2.0
#include "core/triangle_weights.h"

#include <algorithm>

#include "core/area_vector.h"

namespace twinray {

/// How many offsets a point keeps from the edges. In a corner where two walls meet at the angle theta, a
/// point at the distance s from the edge that is then moved off its wall by the offset stands in front of the
/// other wall by s sin(theta) - offset cos(theta). That is one offset or more, which is what a ray needs to
/// hit that wall, for s = cot(theta / 2) offset: 8 offsets do for angles from 14.3 degrees. In a triangle too
/// small for that a point moves by edge_weight of a height, no more.
constexpr double edge_offsets = 8;

TriangleWeights keep_off_edges(const Vec3& a, const Vec3& b, const Vec3& c, const TriangleWeights& weights,
                               float offset) {
  if (std::min(weights.a, std::min(weights.b, weights.c)) >= edge_weight) return weights;
  const double distance_by_area = edge_offsets * offset / AreaVector(a, b, c).length();
  const auto least = [&](const Vec3& edge) {  // the distance over the height of that edge
    return float(std::min(distance_by_area * length(edge), double(edge_weight)));
  };
  const float wa = std::max(weights.a, least(c - b));
  const float wb = std::max(weights.b, least(a - c));
  const float wc = std::max(weights.c, least(b - a));
  const float sum = wa + wb + wc;
  return {1 - wb / sum - wc / sum, wb / sum, wc / sum};
}

}  // namespace twinray
