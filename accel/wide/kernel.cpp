// SPDX-License-Identifier: Apache-2.0
// The way of one ray through an eight-wide BVH, compiled once for each instruction set.
//
// Eight boxes are tested at once by the operations of core/slab.h, in their order and without fused
// multiply-add, so each lane has the bits of intersect_slab and what its monotony promises holds: no box is
// culled that holds an accepted hit. A child waits on the stack as one number, the bits of its entry above
// its name: entries are not negative, so numbers are ordered as entries are.
#include "accel/wide/kernel.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "accel/instruction_sets.h"
#include "accel/wide/scalar.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)  // no faster than the scalar kernel, and than AVX3
#define HWY_TARGET_INCLUDE "accel/wide/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "accel/block_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {
namespace {

using Tag = hn::CappedTag<float, WideNode::width>;
using IntTag = hn::RebindToSigned<Tag>;
using Lanes = hn::Vec<Tag>;
constexpr std::size_t lane_count = hn::MaxLanes(Tag());

/// A ray as the box test wants it: in lanes, with its octant as places of rows in a node.
class BoxRay {
 public:
  HWY_ATTR HWY_INLINE explicit BoxRay(const CheckedRay& ray)
      : t_min_(hn::Set(IntTag(), std::bit_cast<std::int32_t>(ray.t_min + 0.0f))) {
    for (int axis = 0; axis < 3; ++axis) {
      near_origin_[axis] = hn::Set(Tag(), ray.near_origin[axis]);
      far_origin_[axis] = hn::Set(Tag(), ray.far_origin[axis]);
      near_inverse_[axis] = hn::Set(Tag(), ray.near_inverse[axis]);
      far_inverse_[axis] = hn::Set(Tag(), ray.far_inverse[axis]);
      near_row_[axis] = std::size_t(2 * axis + ray.is_negative[axis]) * WideNode::width;
      far_row_[axis] = std::size_t(2 * axis + 1 - ray.is_negative[axis]) * WideNode::width;
    }
  }

  /// Bit i: the ray meets the box of child i within [t_min, t_max], at entries[i], which is never -0.
  HWY_ATTR HWY_INLINE std::uint32_t intersect(const WideNode& node, float t_max, float* entries) const {
    const Lanes exit_limit = hn::Set(Tag(), t_max);
    std::uint32_t met = 0;
    for (std::size_t first = 0; first < WideNode::width; first += lane_count) {
      const Lanes near =
          hn::Max(hn::Max(near_at(node, 0, first), near_at(node, 1, first)), near_at(node, 2, first));
      const Lanes far =
          hn::Min(hn::Min(far_at(node, 0, first), far_at(node, 1, first)), far_at(node, 2, first));
      // The maximum with a number >= +0 as integers is that as floats, and never -0.
      const Lanes entry = hn::BitCast(Tag(), hn::Max(hn::BitCast(IntTag(), near), t_min_));
      hn::Store(entry, Tag(), entries + first);
      met |= bits_of(Tag(), hn::Le(entry, hn::Min(far, exit_limit))) << first;
    }
    return met;
  }

 private:
  HWY_ATTR HWY_INLINE Lanes near_at(const WideNode& node, int axis, std::size_t first) const {
    const Lanes planes = hn::Load(Tag(), node.planes[0][0] + near_row_[axis] + first);
    return hn::Mul(hn::Sub(planes, near_origin_[axis]), near_inverse_[axis]);
  }
  HWY_ATTR HWY_INLINE Lanes far_at(const WideNode& node, int axis, std::size_t first) const {
    const Lanes planes = hn::Load(Tag(), node.planes[0][0] + far_row_[axis] + first);
    return hn::Mul(hn::Sub(planes, far_origin_[axis]), far_inverse_[axis]);
  }

  Lanes near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3];
  hn::Vec<IntTag> t_min_;
  std::size_t near_row_[3], far_row_[3];  ///< Where in a node's planes they are.
};

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

/// Calls `test(block)` for the blocks whose boxes the ray meets between ray.t_min and t_max, about front to
/// back; `test` may lower t_max, and ends the traversal by returning true.
template <typename Test>
HWY_ATTR HWY_INLINE void traverse(const WideBvh& bvh, const CheckedRay& ray, const float& t_max,
                                  Test&& test) {
  if (bvh.root.is_none()) return;
  const BoxRay box_ray(ray);
  const WideNode* const nodes = bvh.nodes.data();
  const TriangleBlock* const blocks = bvh.blocks.data();
  Key stack[wide_stack_size];
  Key* top = stack;
  alignas(32) float entries[WideNode::width];
  WideRef ref = bvh.root;
  for (;;) {
    while (!ref.is_block()) {
      const WideNode& node = nodes[ref.index()];
      std::uint32_t met = box_ray.intersect(node, t_max, entries);
      if (met == 0) break;
      const int first = std::countr_zero(met);
      met &= met - 1;
      if (met == 0) {
        ref = node.children[first];
        continue;
      }
      Key key = key_of(entries, node, first), other = key_of(entries, node, std::countr_zero(met));
      met &= met - 1;
      if (met == 0) {
        order(other, key);
        *top++ = other;
      } else {
        Key* const lowest = top;
        *top++ = key;
        *top++ = other;
        for (; met != 0; met &= met - 1) *top++ = key_of(entries, node, std::countr_zero(met));
        sort(lowest, top - lowest);
        key = *--top;
      }
      ref = {std::uint32_t(key)};
    }
    if (ref.is_block() && test(blocks[ref.index()])) return;
    const std::uint32_t limit = std::bit_cast<std::uint32_t>(t_max + 0.0f);
    Key key;
    do {
      if (top == stack) return;
      key = *--top;
    } while (key >> 32 > limit);
    ref = {std::uint32_t(key)};
  }
}

/// Whether `test(block)` is true for any of the blocks whose boxes the ray meets, in no order: to sort them
/// took longer than the blocks that it saved, 8 % on shadow rays.
template <typename Test>
HWY_ATTR HWY_INLINE bool traverse_any(const WideBvh& bvh, const CheckedRay& ray, Test&& test) {
  if (bvh.root.is_none()) return false;
  const BoxRay box_ray(ray);
  const WideNode* const nodes = bvh.nodes.data();
  const TriangleBlock* const blocks = bvh.blocks.data();
  std::uint32_t stack[wide_stack_size];  // Of WideRefs' bits; as numbers they need not be initialised.
  std::uint32_t* top = stack;
  WideRef ref = bvh.root;
  for (;;) {
    std::uint32_t met = 0;
    if (ref.is_block()) {
      if (test(blocks[ref.index()])) return true;
    } else {
      const WideNode& node = nodes[ref.index()];
      alignas(32) float entries[WideNode::width];
      met = box_ray.intersect(node, ray.t_max, entries);
      if (met != 0) {
        ref = node.children[std::countr_zero(met)];
        for (met &= met - 1; met != 0; met &= met - 1) *top++ = node.children[std::countr_zero(met)].bits;
        continue;
      }
    }
    if (top == stack) return false;
    ref = {*--top};
  }
}

HWY_ATTR Hit closest(const WideBvh& bvh, const Geometry& geometry, const CheckedRay& ray) {
  Nearest best;
  float t_max = ray.t_max;
  const BlockRay block_ray(ray);
  traverse(bvh, ray, t_max, [&](const TriangleBlock& block) HWY_ATTR {
    block_ray.closest(ray, block, best);
    if (block.others) best.test(geometry, ray, block, block.others);
    t_max = std::min(t_max, best.t);
    return false;
  });
  return best.hit();
}

HWY_ATTR bool any(const WideBvh& bvh, const Geometry& geometry, const CheckedRay& ray) {
  const BlockRay block_ray(ray);
  return traverse_any(bvh, ray, [&](const TriangleBlock& block) HWY_ATTR {
    return block_ray.any(ray, block) || (block.others && any_other(geometry, ray, block));
  });
}

HWY_ATTR std::uint32_t meet(const WideNode& node, const CheckedRay& ray, float t_max, float* entries) {
  alignas(32) float stored[WideNode::width];
  const std::uint32_t met = BoxRay(ray).intersect(node, t_max, stored);
  std::copy(std::begin(stored), std::end(stored), entries);
  return met;
}

[[maybe_unused]] WideKernel kernel() { return {simd_name(hwy::TargetName(HWY_TARGET)), closest, any, meet}; }

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twinray {
namespace {

template <TriangleTest test>
WideKernel scalar() {
  return {"scalar",
          [](const WideBvh& bvh, const Geometry& geometry, const CheckedRay& ray) {
            QueryCounts counts;
            return scalar_closest<test>(bvh, geometry, ray, counts);
          },
          [](const WideBvh& bvh, const Geometry& geometry, const CheckedRay& ray) {
            QueryCounts counts;
            return scalar_any<test>(bvh, geometry, ray, counts);
          },
          scalar_meet};
}

}  // namespace

std::vector<WideKernel> wide_kernels(TriangleTest test) {
  if (test == TriangleTest::moller_trumbore) return {scalar<TriangleTest::moller_trumbore>()};
  std::vector<WideKernel> kernels;
  const auto supported = hwy::SupportedTargets();
#if HWY_TARGETS & HWY_AVX3
  if (supported & HWY_AVX3) kernels.push_back(N_AVX3::kernel());
#endif
#if HWY_TARGETS & HWY_AVX2
  if (supported & HWY_AVX2) kernels.push_back(N_AVX2::kernel());
#endif
#if HWY_TARGETS & HWY_SSE4
  if (supported & HWY_SSE4) kernels.push_back(N_SSE4::kernel());
#endif
  kernels.push_back(scalar<TriangleTest::woop>());
  return kernels;
}

}  // namespace twinray
#endif
