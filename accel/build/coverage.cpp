// SPDX-License-Identifier: Apache-2.0
#include "accel/build/coverage.h"

#include <fmt/format.h>

#include "accel/canonical/slab.h"

namespace twinray {
namespace {

/// Whether they overlap, at least in a face.
bool overlap(const Aabb& a, const Aabb& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.lower[axis] > b.upper[axis] || b.lower[axis] > a.upper[axis]) return false;
  return true;
}

}  // namespace

bool is_covered(const Aabb& box, std::span<const Aabb> boxes) {
  for (const Aabb& other : boxes)
    if (other.contains(box)) return true;
  for (const Aabb& other : boxes) {
    if (!overlap(box, other)) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (const float plane : {other.lower[axis], other.upper[axis]})
        if (plane > box.lower[axis] && plane < box.upper[axis]) {
          Aabb first = box, second = box;
          first.upper[axis] = second.lower[axis] = plane;
          return is_covered(first, boxes) && is_covered(second, boxes);
        }
  }
  return false;
}

LeavesOfPrimitives::LeavesOfPrimitives(const Geometry& geometry) : geometry_(geometry) {
  for (std::uint32_t shape = 0; shape < geometry.shapes().size(); ++shape) {
    const Mesh* mesh = geometry.mesh(shape);
    boxes_.emplace_back(mesh ? mesh->triangles.size() : geometry.sphere_set(shape)->spheres.size());
  }
}

std::string LeavesOfPrimitives::add(PrimitiveId id, const Aabb& leaf) {
  if (id.mesh >= boxes_.size() || id.primitive >= boxes_[id.mesh].size())
    return fmt::format("there is no primitive {} of shape {}", id.primitive, id.mesh);
  boxes_[id.mesh][id.primitive].push_back(leaf);
  return "";
}

std::string LeavesOfPrimitives::fault(Occurrence occurrence) const {
  for (std::uint32_t shape = 0; shape < boxes_.size(); ++shape)
    for (std::uint32_t i = 0; i < boxes_[shape].size(); ++i) {
      const std::vector<Aabb>& leaves = boxes_[shape][i];
      if (leaves.empty() || (occurrence == Occurrence::once && leaves.size() > 1))
        return fmt::format("primitive {} of shape {} lies in {} leaves", i, shape, leaves.size());
      if (!is_covered(padded(primitive_bounds(geometry_, {shape, i})), leaves))
        return fmt::format("primitive {} of shape {} leaves its leaf's box", i, shape);
    }
  return "";
}

}  // namespace twinray
