// SPDX-License-Identifier: Apache-2.0
// Private: what traversals report their steps to. Each is written once and compiled twice: the timed build
// with NoCounts, which is nothing, the counting one with Counting.
#pragma once
#include "accel/canonical/primitive_block.h"
#include "accel/counters.h"

namespace twinray {

struct NoCounts {
  template <typename Node>
  void visit_node(const Node&) const {}
  void visit_leaf() const {}
  void test_box() const {}
  void test_block(const PrimitiveBlock&) const {}
  void enter_instance() const {}
};

/// Adds steps to the counts of a query.
struct Counting {
  QueryCounts& counts;

  /// All of its children's boxes are tested.
  template <typename Node>
  void visit_node(const Node& node) const {
    ++counts.nodes;
    counts.boxes += std::uint64_t(node.count());
  }
  void visit_leaf() const { ++counts.leaves; }
  void test_box() const { ++counts.boxes; }
  void test_block(const PrimitiveBlock& block) const { counts.primitives += block.count; }
  void enter_instance() const { ++counts.instances; }
};

/// The one that goes with the arguments of a traversal: counts, or none.
inline NoCounts steps_of() { return {}; }
inline Counting steps_of(QueryCounts& counts) { return {counts}; }

}  // namespace twinray
