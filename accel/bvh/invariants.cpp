// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/invariants.h"

#include <fmt/format.h>

#include <vector>

#include "accel/canonical/slab.h"

namespace twinray {
namespace {

class Inspection {
 public:
  Inspection(const Bvh& bvh, const Geometry& geometry, int max_leaf_size)
      : bvh_(bvh), max_leaf_size_(max_leaf_size), leaves_(geometry) {}

  std::string fault(const Geometry& geometry, Occurrence occurrence) {
    if (geometry.primitive_count() > 0) visit(bvh_.root, bvh_.box, 0);
    return fault_.empty() ? leaves_.fault(occurrence) : fault_;
  }

 private:
  template <typename... Values>
  void report(fmt::format_string<Values...> text, Values&&... values) {
    if (fault_.empty()) fault_ = fmt::format(text, std::forward<Values>(values)...);
  }

  void visit(const NodeRef& node, const Aabb& box, int depth) {
    if (depth > max_bvh_depth) return report("a node is {} deep; the stack holds {}", depth, max_bvh_depth);
    if (node.is_leaf()) return visit_leaf(node, box);
    if (node.first >= bvh_.pairs.size())
      return report("pair {} is named, of {}", node.first, bvh_.pairs.size());
    const NodePair& pair = bvh_.pairs[node.first];
    for (int child = 0; child < 2; ++child) {
      if (!box.contains(pair.box(child))) report("child {} of pair {} leaves its parent", child, node.first);
      visit(pair.children[child], pair.box(child), depth + 1);
    }
  }

  void visit_leaf(const NodeRef& node, const Aabb& box) {
    int primitives = 0;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (i >= bvh_.blocks.size()) return report("block {} is named, of {}", i, bvh_.blocks.size());
      for (std::uint32_t lane = 0; lane < bvh_.blocks[i].count; ++lane, ++primitives)
        if (const std::string fault = leaves_.add(bvh_.blocks[i].ids[lane], box); !fault.empty())
          report("{}", fault);
    }
    if (primitives == 0 || primitives > max_leaf_size_) report("a leaf holds {} primitives", primitives);
  }

  const Bvh& bvh_;
  int max_leaf_size_;
  LeavesOfPrimitives leaves_;
  std::string fault_;
};

/// Whether they meet, in more than a face.
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

std::string find_fault(const Bvh& bvh, const Geometry& geometry, int max_leaf_size, Occurrence occurrence) {
  return Inspection(bvh, geometry, max_leaf_size).fault(geometry, occurrence);
}

}  // namespace twinray
