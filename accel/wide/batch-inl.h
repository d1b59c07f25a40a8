// SPDX-License-Identifier: Apache-2.0
// Private: batches of queries over an eight-wide BVH, compiled once for each instruction set.
//
// Many queries are on their way at once, and advance in rounds: each takes its next node or block from its
// stack, then all nodes are visited, then all blocks. So while one query waits for memory the others go on,
// and no branch need be predicted about the next step of any: whether it is a node or a block is a place in a
// queue, and how many children are hit is only a number. What a visit puts on a stack is not read before the
// next round: at once, the read would have to wait until the wide store is done.
#if defined(TWINRAY_ACCEL_WIDE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_BATCH_INL_H
#undef TWINRAY_ACCEL_WIDE_BATCH_INL_H
#else
#define TWINRAY_ACCEL_WIDE_BATCH_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

#include "accel/canonical/block_test-inl.h"
#include "accel/canonical/load_ray-inl.h"
#include "accel/counting.h"
#include "accel/wide/box_test-inl.h"
#include "accel/wide/open_leaves-inl.h"
#include "accel/wide/stack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A closest-hit query on its way through a tree with primitives.
template <typename Bvh>
class ClosestQuery {
 public:
  using Tree = Bvh;
  using Answer = Hit;
  static constexpr bool has_instances = false;

  /// False for an invalid ray.
  HWY_ATTR HWY_INLINE bool start(const Geometry&, const Ray& given, WideRef root) {
    if (!RayLoader::load(given, ray_)) return false;
    new (&best_) Nearest;  // Without a value for what has none yet.
    t_max_ = ray_.t_max;
    stack_[0] = bottom;
    stack_[1] = root.bits;
    top_ = stack_ + 2;
    return true;
  }
  /// Takes what comes next from the stack; none where the query is answered.
  HWY_ATTR HWY_INLINE WideRef advance() { return next_ = pop_to_bottom(top_, t_max_); }
  /// What it was.
  WideRef next() const { return next_; }

  HWY_ATTR HWY_INLINE void visit(const typename Tree::Node& node) {
    alignas(32) float entries[WideNode::width];
    const std::uint32_t met = BoxRay(ray_).intersect(node, t_max_, entries);
    push_sorted(node.children, met, entries, top_);
  }
  template <typename Steps>
  HWY_ATTR HWY_INLINE void visit_leaf(const Tree& bvh, const Geometry& geometry, const Steps& steps) {
    const PrimitiveBlock& block = leaves_.open(bvh, next_);
    steps.test_block(block);
    BlockRay(ray_).closest(geometry, ray_, block, best_);
    leaves_.keep(best_);
    t_max_ = std::min(t_max_, best_.t);
  }
  Hit answer() const {
    Hit hit = best_.hit(ray_);
    ray_.scale_back(hit);
    return hit;
  }

 private:
  CheckedRay ray_;
  Nearest best_;
  [[no_unique_address]] OpenLeaves<Tree> leaves_;
  float t_max_;
  WideRef next_;
  Key* top_;
  Key stack_[wide_stack_size];
};

/// An any-hit query, likewise.
template <typename Bvh>
class AnyQuery {
 public:
  using Tree = Bvh;
  using Answer = std::uint8_t;
  static constexpr bool has_instances = false;

  HWY_ATTR HWY_INLINE bool start(const Geometry&, const Ray& given, WideRef root) {
    if (!RayLoader::load(given, ray_)) return false;
    is_hit_ = false;
    stack_[0] = WideRef::no_child;
    stack_[1] = root.bits;
    top_ = stack_ + 2;
    return true;
  }
  HWY_ATTR HWY_INLINE WideRef advance() { return next_ = {*--top_}; }
  WideRef next() const { return next_; }

  HWY_ATTR HWY_INLINE void visit(const typename Tree::Node& node) {
    alignas(32) float entries[WideNode::width];
    const std::uint32_t met = BoxRay(ray_).intersect(node, ray_.t_max, entries);
    push_all(node.children, met, top_);
  }
  template <typename Steps>
  HWY_ATTR HWY_INLINE void visit_leaf(const Tree& bvh, const Geometry& geometry, const Steps& steps) {
    OpenLeaves<Tree> leaves;
    const PrimitiveBlock& block = leaves.open(bvh, next_);
    steps.test_block(block);
    is_hit_ = BlockRay(ray_).any(geometry, ray_, block);
    top_ = is_hit_ ? stack_ + 1 : top_;  // Nothing is next then.
  }
  bool answer() const { return is_hit_; }

 private:
  CheckedRay ray_;
  bool is_hit_;
  WideRef next_;
  std::uint32_t* top_;
  std::uint32_t stack_[wide_stack_size];  ///< Of WideRefs' bits; as numbers they need not be initialised.
};

/// Enough for memory to keep up with: 16 are 10 % slower where a tree does not fit into the caches, 48 as
/// fast.
constexpr std::uint32_t queries_in_flight = 32;

/// Some of the queries in flight, by their places.
class Queue {
 public:
  /// Adds a query if `is_in`, without a branch.
  HWY_INLINE void add(std::uint32_t query, bool is_in = true) {
    queries_[size_] = query;
    size_ += is_in;
  }
  void clear() { size_ = 0; }
  bool is_empty() const { return size_ == 0; }
  const std::uint32_t* begin() const { return queries_; }
  const std::uint32_t* end() const { return queries_ + size_; }

 private:
  std::uint32_t queries_[queries_in_flight];
  std::size_t size_ = 0;
};

/// The rays of a batch, and the queries that answer them.
template <typename Query>
class Batch {
 public:
  using Tree = typename Query::Tree;

  Batch(const Tree& bvh, const Geometry& geometry, std::span<const Ray> rays, typename Query::Answer* answers)
      : bvh_(bvh), geometry_(geometry), rays_(rays), answers_(answers) {}

  /// Steps: NoCounts, or Counting.
  template <typename Steps>
  HWY_ATTR void answer(const Steps& steps) {
    Queue active;
    for (std::uint32_t i = 0; i < queries_in_flight; ++i) active.add(i, start(i));
    while (!active.is_empty()) {
      Queue nodes, blocks, instances, answered;
      for (const std::uint32_t i : active) {
        const WideRef next = queries_[i].advance();
        const bool is_instance = Query::has_instances && next.is_instance();
        nodes.add(i, !next.is_leaf());
        blocks.add(i, next.is_leaf() && !is_instance && !next.is_none());
        if (Query::has_instances) instances.add(i, next.is_leaf() && is_instance && !next.is_none());
        answered.add(i, next.is_none());
      }
      for (const std::uint32_t i : nodes) prefetch(next_node(i));
      for (const std::uint32_t i : blocks) OpenLeaves<Tree>::prefetch(bvh_, queries_[i].next());
      if constexpr (Query::has_instances)
        for (const std::uint32_t i : instances) prefetch(next_instance(i));
      active.clear();
      for (const std::uint32_t i : answered) {
        answers_[ray_of_[i]] = queries_[i].answer();
        active.add(i, start(i));
      }
      for (const std::uint32_t i : nodes) {
        steps.visit_node(next_node(i));
        queries_[i].visit(next_node(i));
        active.add(i);
      }
      for (const std::uint32_t i : blocks) {
        steps.visit_leaf();
        queries_[i].visit_leaf(bvh_, geometry_, steps);
        active.add(i);
      }
      if constexpr (Query::has_instances)
        for (const std::uint32_t i : instances) {
          steps.visit_leaf();
          const WideRef root = bvh_.prototypes[next_instance(i).prototype];
          if (queries_[i].enter(geometry_.placed(), root)) steps.enter_instance();
          active.add(i);
        }
    }
  }

 private:
  /// Starts a query with the next valid ray, and answers the invalid ones before it; false where none is
  /// left.
  HWY_ATTR HWY_INLINE bool start(std::uint32_t query) {
    while (started_ < rays_.size()) {
      const std::size_t ray = started_++;
      ray_of_[query] = ray;
      if (!bvh_.root.is_none() && queries_[query].start(geometry_, rays_[ray], bvh_.root)) return true;
      answers_[ray] = {};
    }
    return false;
  }
  const typename Tree::Node& next_node(std::uint32_t query) const {
    return bvh_.node(queries_[query].next());
  }
  const PlacedInstance& next_instance(std::uint32_t query) const {
    return geometry_.placed()[queries_[query].next().index()];
  }

  const Tree& bvh_;
  const Geometry& geometry_;
  const std::span<const Ray> rays_;
  typename Query::Answer* const answers_;
  std::size_t started_ = 0;
  std::size_t ray_of_[queries_in_flight];
  Query queries_[queries_in_flight];
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
