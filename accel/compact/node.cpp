// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/node.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

constexpr int most_steps = 255;

/// Chooses the shortest step by which the planes of an axis can be counted.
void set_steps(CompactNode& node, int axis, float lower, float upper) {
  node.origin[axis] = lower;
  int exponent = 0;
  std::frexp((upper - lower) / most_steps, &exponent);
  node.exponents[axis] = std::uint8_t(std::clamp(exponent + 126, 1, 254));  // Of half of 2^exponent.
  while (node.plane(axis, most_steps) < upper) ++node.exponents[axis];
}

/// How many steps a plane may be moved down to from above, or up to from below.
int steps_from(const CompactNode& node, int axis, float plane) {
  return std::clamp(int((plane - node.origin[axis]) / node.step(axis)), 0, most_steps);
}

std::uint8_t steps_below(const CompactNode& node, int axis, float plane) {
  int steps = steps_from(node, axis, plane);
  while (steps < most_steps && node.plane(axis, steps + 1) <= plane) ++steps;
  while (node.plane(axis, steps) > plane) --steps;
  return std::uint8_t(steps);
}

std::uint8_t steps_above(const CompactNode& node, int axis, float plane) {
  int steps = steps_from(node, axis, plane);
  while (steps > 0 && node.plane(axis, steps - 1) >= plane) --steps;
  while (node.plane(axis, steps) < plane) ++steps;
  return std::uint8_t(steps);
}

}  // namespace

CompactNode::CompactNode(const WideNode& node) : planes{}, child_count(std::uint8_t(node.count())) {
  Aabb all;
  for (int child = 0; child < child_count; ++child) all.extend(node.box(child));
  std::copy(std::begin(node.children), std::end(node.children), children);
  for (int axis = 0; axis < 3; ++axis) {
    set_steps(*this, axis, all.lower[axis], all.upper[axis]);
    for (int child = 0; child < child_count; ++child) {
      planes[axis][0][child] = steps_below(*this, axis, node.box(child).lower[axis]);
      planes[axis][1][child] = steps_above(*this, axis, node.box(child).upper[axis]);
    }
  }
}

}  // namespace twinray
