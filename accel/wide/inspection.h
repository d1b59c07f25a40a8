// SPDX-License-Identifier: Apache-2.0
// Private: the inspection of either tree; compiled in instantiations.cpp.
#pragma once
#include "accel/wide/invariants.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "accel/canonical/slab.h"

namespace twinray {
namespace {

/// Tree: WideBvh, whose boxes contain those of their children, or CompactBvh, whose boxes contain the
/// primitives, but are rounded outward each by itself.
template <typename Tree>
class Inspection {
 public:
  Inspection(const Tree& bvh, const Geometry& geometry)
      : bvh_(bvh),
        geometry_(geometry),
        nodes_(bvh.nodes.size()),
        blocks_(bvh.block_places()),
        instances_(geometry.instances().size()),
        leaves_(geometry) {}

  std::string fault(Occurrence occurrence) {
    constexpr float everywhere = Aabb::infinity;
    const Aabb all{{-everywhere, -everywhere, -everywhere}, {everywhere, everywhere, everywhere}};
    // A root that joins two trees lies above what either may be deep.
    const bool is_joined =
        geometry_.has_instances() && geometry_.primitive_count(geometry_.direct_shapes()) > 0;
    if (!bvh_.root.is_none()) visit(bvh_.root, all, is_joined ? -1 : 0);
    for (const WideRef& prototype : bvh_.prototypes)
      if (!prototype.is_none()) visit(prototype, all, 0);
    check_instances();
    check_seen_once("node", nodes_);
    check_blocks();
    return fault_.empty() ? leaves_.fault(occurrence) : fault_;
  }

 private:
  static constexpr bool is_exact = std::is_same_v<Tree, WideBvh>;

  /// What all boxes on the way to a leaf have in common, in which a ray must find its primitives.
  static Aabb intersection(Aabb a, const Aabb& b) {
    for (int axis = 0; axis < 3; ++axis) {
      a.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
      a.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
    }
    return a;
  }

  /// Packed blocks lie at some places; that each is found once follows from their primitives.
  void check_blocks() {
    if (is_exact) check_seen_once("block", blocks_);
  }

  template <typename... Values>
  void report(fmt::format_string<Values...> text, Values&&... values) {
    if (fault_.empty()) fault_ = fmt::format(text, std::forward<Values>(values)...);
  }

  void check_seen_once(const char* what, const std::vector<int>& seen) {
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (seen[i] != 1) report("{} {} is found {} times", what, i, seen[i]);
  }

  /// Those that can be hit are found once, the others never.
  void check_instances() {
    for (std::uint32_t i = 0; i < instances_.size(); ++i)
      if (instances_[i] != int(!geometry_.placed()[i].box.is_empty()))
        report("instance {} is found {} times", i, instances_[i]);
  }

  void visit(const WideRef& ref, const Aabb& box, int depth) {
    if (depth > max_wide_depth) return report("a node is {} deep; the stack holds {}", depth, max_wide_depth);
    if (ref.is_leaf() && ref.is_instance()) return visit_instance(ref.index(), box);
    const std::size_t count = ref.is_leaf() ? blocks_.size() : nodes_.size();
    if (ref.index() >= count)
      return report("{} {} is named, of {}", ref.is_leaf() ? "block" : "node", ref.index(), count);
    if (ref.is_leaf()) return visit_block(ref.index(), box);
    ++nodes_[ref.index()];
    const typename Tree::Node& node = bvh_.node(ref);
    const int children = node.count();
    if (children < 2) report("node {} has {} children", ref.index(), children);
    for (int child = 0; child < children; ++child) {
      if (is_exact && !box.contains(node.box(child)))
        report("child {} of node {} leaves its parent", child, ref.index());
      visit(node.children[child], intersection(box, node.box(child)), depth + 1);
    }
    for (int child = children; child < WideNode::width; ++child)
      if (!node.children[child].is_none() || (is_exact && !node.box(child).is_empty()))
        report("child {} of node {}, which has {}, can be met", child, ref.index(), children);
  }

  void visit_instance(std::uint32_t index, const Aabb& box) {
    if (index >= instances_.size()) return report("instance {} is named, of {}", index, instances_.size());
    ++instances_[index];
    if (!box.contains(geometry_.placed()[index].box)) report("instance {} leaves its leaf", index);
  }

  void visit_block(std::uint32_t index, const Aabb& box) {
    ++blocks_[index];
    const PrimitiveBlock& block = bvh_.block(WideRef::block(index));
    if (block.count == 0 || block.count > std::uint32_t(PrimitiveBlock::width))
      return report("block {} holds {} primitives", index, block.count);
    for (std::uint32_t lane = 0; lane < block.count; ++lane)
      if (const std::string fault = leaves_.add(block.ids[lane], box); !fault.empty()) report("{}", fault);
  }

  const Tree& bvh_;
  const Geometry& geometry_;
  std::vector<int> nodes_, blocks_, instances_;
  LeavesOfPrimitives leaves_;
  std::string fault_;
};

}  // namespace

template <typename Tree>
std::string find_fault(const Tree& bvh, const Geometry& geometry, Occurrence occurrence) {
  return Inspection<Tree>(bvh, geometry).fault(occurrence);
}

}  // namespace twinray
