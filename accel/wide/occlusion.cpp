// SPDX-License-Identifier: Apache-2.0
#include "accel/wide/occlusion.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// A block takes about half as long as a node and what follows from it.
constexpr float block_cost = 0.5f;

double area(const PrimitiveBlock& block, int lane) {
  const Vec3 a = block.corner(0, lane);
  return 0.5 * length(cross(block.corner(1, lane) - a, block.corner(2, lane) - a));
}

/// Of all primitives of a block. What is no triangle is taken for a sphere, whose box has twice the half area
/// of its surface, about.
double area(const Geometry& geometry, const PrimitiveBlock& block) {
  double sum = 0;
  for (int lane = 0; lane < int(block.count); ++lane)
    sum += (block.spheres | block.others) >> lane & 1
               ? primitive_bounds(geometry, block.ids[lane]).half_area() / 2
               : area(block, lane);
  return sum;
}

double rank(const Candidate& child) {
  return double(child.prospect.occlusion) / child.prospect.cost * std::sqrt(child.half_area);
}

}  // namespace

Prospect prospect_of(const Geometry& geometry, const PrimitiveBlock& block, double half_area) {
  const double crossings = half_area > 0 ? area(geometry, block) / half_area : 0;
  const bool is_number = crossings <= 1e9;  // Areas of the largest triangles are not.
  return {is_number ? float(crossings / (1 + crossings)) : 1, block_cost};
}

Prospect prospect_of(std::span<const Candidate> children, double half_area) {
  double cost = 1, missed = 1;
  for (const Candidate& child : children) {
    const double met = half_area > 0 ? std::min(1.0, child.half_area / half_area) : 1;
    cost += missed * met * child.prospect.cost;
    missed *= 1 - met * child.prospect.occlusion;
  }
  return {float(1 - missed), float(cost)};
}

void sort_for_occlusion(std::span<Candidate> children) {
  double ranks[WideNode::width];
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Candidate child = children[i];
    const double own = rank(child);
    std::size_t place = i;
    for (; place > 0 && ranks[place - 1] < own; --place) {
      ranks[place] = ranks[place - 1];
      children[place] = children[place - 1];
    }
    ranks[place] = own;
    children[place] = child;
  }
}

}  // namespace twinray
