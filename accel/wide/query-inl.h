// SPDX-License-Identifier: Apache-2.0
// Private: the way of one ray through an eight-wide BVH, step by step, compiled once for each instruction
// set.
#if defined(TWINRAY_ACCEL_WIDE_QUERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_QUERY_INL_H
#undef TWINRAY_ACCEL_WIDE_QUERY_INL_H
#else
#define TWINRAY_ACCEL_WIDE_QUERY_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/block_test-inl.h"
#include "accel/wide/box_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A child that waits on the stack: the bits of its entry above its name. Entries are not negative, so these
/// numbers are ordered as entries are.
using Key = std::uint64_t;

HWY_ATTR HWY_INLINE Key key_of(const float* entries, const WideNode& node, int child) {
  return Key(std::bit_cast<std::uint32_t>(entries[child])) << 32 | node.children[child].bits;
}

HWY_ATTR HWY_INLINE void order(Key& larger, Key& smaller) {
  const Key a = larger, b = smaller;
  larger = a > b ? a : b;
  smaller = a > b ? b : a;
}

/// Sorts three or more keys, the largest first: the first four by a network, others by insertion.
HWY_ATTR HWY_INLINE void sort(Key* keys, std::ptrdiff_t count) {
  order(keys[0], keys[1]);
  if (count == 3) {
    order(keys[1], keys[2]);
    order(keys[0], keys[1]);
    return;
  }
  order(keys[2], keys[3]);
  order(keys[0], keys[2]);
  order(keys[1], keys[3]);
  order(keys[1], keys[2]);
  for (std::ptrdiff_t i = 4; i < count; ++i) {
    const Key key = keys[i];
    std::ptrdiff_t place = i;
    for (; place > 0 && keys[place - 1] < key; --place) keys[place] = keys[place - 1];
    keys[place] = key;
  }
}

/// The nearest of the children that the ray meets, one at least; the others wait on the stack, the nearer
/// the higher.
HWY_ATTR HWY_INLINE WideRef nearest_child(const WideNode& node, std::uint32_t met, const float* entries,
                                          Key*& top) {
  const int first = std::countr_zero(met);
  met &= met - 1;
  if (met == 0) return node.children[first];
  Key key = key_of(entries, node, first), other = key_of(entries, node, std::countr_zero(met));
  met &= met - 1;
  if (met == 0) {
    order(other, key);
    *top++ = other;
    return {std::uint32_t(key)};
  }
  Key* const lowest = top;
  *top++ = key;
  *top++ = other;
  for (; met != 0; met &= met - 1) *top++ = key_of(entries, node, std::countr_zero(met));
  sort(lowest, top - lowest);
  return {std::uint32_t(*--top)};
}

/// Takes the topmost child that the ray enters at t_max or before; none where there is no such.
HWY_ATTR HWY_INLINE WideRef pop(const Key* stack, Key*& top, float t_max) {
  const std::uint32_t limit = std::bit_cast<std::uint32_t>(t_max + 0.0f);
  while (top != stack)
    if (const Key key = *--top; key >> 32 <= limit) return {std::uint32_t(key)};
  return {};
}

/// Puts children of a node on the stack, of whose places `top` and the seven behind it may be written.
HWY_ATTR HWY_INLINE void push(const WideNode& node, std::uint32_t children, std::uint32_t*& top) {
#if HWY_TARGET <= HWY_AVX3
  // All at once, for the end of a loop is mispredicted: 10 % on shadow rays. What other sets of instructions
  // take for it is slower than the loop.
  const hn::FixedTag<std::uint32_t, WideNode::width> tag;
  const std::uint8_t bits[8] = {std::uint8_t(children)};
  hn::StoreU(hn::CompressBits(hn::Load(tag, &node.children[0].bits), bits), tag, top);
  top += std::popcount(children);
#else
  for (; children != 0; children &= children - 1) *top++ = node.children[std::countr_zero(children)].bits;
#endif
}

/// The first of the children that the ray meets; the others wait on the stack, as they come: to sort them by
/// distance took longer than the blocks that it saved, 8 % on shadow rays.
HWY_ATTR HWY_INLINE WideRef any_child(const WideNode& node, std::uint32_t met, std::uint32_t*& top) {
  const WideRef child = node.children[std::countr_zero(met)];
  met &= met - 1;
  if (met != 0) push(node, met, top);
  return child;
}

/// A closest-hit query on its way through a tree with primitives.
class ClosestQuery {
 public:
  /// The ray must outlive the query.
  HWY_ATTR HWY_INLINE ClosestQuery(const CheckedRay& ray, WideRef root)
      : ray_(ray), box_ray_(ray), block_ray_(ray), t_max_(ray.t_max), next_(root), top_(stack_) {}

  /// The node or block of the next step.
  WideRef next() const { return next_; }
  /// Visits it; false where the query is answered.
  HWY_ATTR HWY_INLINE bool step(const WideBvh& bvh, const Geometry& geometry) {
    if (next_.is_block()) {
      block_ray_.closest(geometry, ray_, bvh.blocks[next_.index()], best_);
      t_max_ = std::min(t_max_, best_.t);
    } else {
      const WideNode& node = bvh.nodes[next_.index()];
      alignas(32) float entries[WideNode::width];
      if (const std::uint32_t met = box_ray_.intersect(node, t_max_, entries)) {
        next_ = nearest_child(node, met, entries, top_);
        return true;
      }
    }
    next_ = pop(stack_, top_, t_max_);
    return !next_.is_none();
  }
  Hit answer() const {
    Hit hit = best_.hit();
    ray_.scale_back(hit);
    return hit;
  }

 private:
  const CheckedRay& ray_;
  const BoxRay box_ray_;
  const BlockRay block_ray_;
  Nearest best_;
  float t_max_;
  WideRef next_;
  Key* top_;
  Key stack_[wide_stack_size];
};

/// An any-hit query, likewise.
class AnyQuery {
 public:
  HWY_ATTR HWY_INLINE AnyQuery(const CheckedRay& ray, WideRef root)
      : ray_(ray), box_ray_(ray), block_ray_(ray), next_(root), top_(stack_) {}

  WideRef next() const { return next_; }
  HWY_ATTR HWY_INLINE bool step(const WideBvh& bvh, const Geometry& geometry) {
    if (next_.is_block()) {
      is_hit_ = block_ray_.any(geometry, ray_, bvh.blocks[next_.index()]);
      if (is_hit_) return false;
    } else {
      const WideNode& node = bvh.nodes[next_.index()];
      alignas(32) float entries[WideNode::width];
      if (const std::uint32_t met = box_ray_.intersect(node, ray_.t_max, entries)) {
        next_ = any_child(node, met, top_);
        return true;
      }
    }
    if (top_ == stack_) return false;
    next_ = {*--top_};
    return true;
  }
  bool answer() const { return is_hit_; }

 private:
  const CheckedRay& ray_;
  const BoxRay box_ray_;
  const BlockRay block_ray_;
  bool is_hit_ = false;
  WideRef next_;
  std::uint32_t* top_;
  std::uint32_t stack_[wide_stack_size];  ///< Of WideRefs' bits; as numbers they need not be initialised.
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
