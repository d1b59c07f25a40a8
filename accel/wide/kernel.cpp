// SPDX-License-Identifier: Apache-2.0
// The queries over an eight-wide BVH, compiled once for each instruction set.
#include "accel/wide/kernel.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <new>
#include <span>

#include "accel/counting.h"
#include "accel/wide/scalar.h"
#include "core/instruction_sets.h"

#define HWY_TARGET_INCLUDE "accel/wide/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128  // Scalar::kernel() serves for these.
#include "accel/canonical/load_ray-inl.h"
#include "accel/wide/batch-inl.h"
#include "accel/wide/stack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {
namespace {

// The single queries have loops of their own: while one waits for the number of children that it hits there
// is nothing else to do, so a predicted branch is faster there.

template <typename... Counts>
HWY_ATTR HWY_INLINE Hit closest(const WideBvh& bvh, const Geometry& geometry, const Ray& given,
                                Counts&... counts) {
  const auto steps = steps_of(counts...);
  Hit hit;  // The one variable that every path returns: it is written where it goes.
  CheckedRay ray;
  if (bvh.root.is_none() || !RayLoader::load(given, ray)) return hit;
  const BoxRay box_ray(ray);
  const BlockRay block_ray(ray);
  Nearest best;
  float t_max = ray.t_max;
  Key stack[wide_stack_size];
  Key* top = stack;
  WideRef ref = bvh.root;
  for (;;) {
    while (!ref.is_block()) {
      const WideNode& node = bvh.nodes[ref.index()];
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, t_max, entries);
      if (met == 0) break;
      ref = nearest_child(node, met, entries, top);
    }
    if (ref.is_block()) {
      const PrimitiveBlock& block = bvh.blocks[ref.index()];
      steps.visit_leaf();
      steps.test_block(block);
      block_ray.closest(geometry, ray, block, best);
      t_max = std::min(t_max, best.t);
    }
    ref = pop(stack, top, t_max);
    if (ref.is_none()) break;
  }
  hit = best.hit();
  ray.scale_back(hit);
  return hit;
}

template <typename... Counts>
HWY_ATTR HWY_INLINE bool any(const WideBvh& bvh, const Geometry& geometry, const Ray& given,
                             Counts&... counts) {
  const auto steps = steps_of(counts...);
  CheckedRay ray;
  if (bvh.root.is_none() || !RayLoader::load(given, ray)) return false;
  const BoxRay box_ray(ray);
  const BlockRay block_ray(ray);
  std::uint32_t stack[wide_stack_size];
  std::uint32_t* top = stack;
  WideRef ref = bvh.root;
  for (;;) {
    while (!ref.is_block()) {
      const WideNode& node = bvh.nodes[ref.index()];
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, ray.t_max, entries);
      if (met == 0) break;
      ref = any_child(node, met, top);
    }
    if (ref.is_block()) {
      const PrimitiveBlock& block = bvh.blocks[ref.index()];
      steps.visit_leaf();
      steps.test_block(block);
      if (block_ray.any(geometry, ray, block)) return true;
    }
    if (top == stack) return false;
    ref = {*--top};
  }
}

// Without a call for each ray, and with each answer written where it goes, what many rays have in common is
// done once.

template <typename... Counts>
HWY_ATTR void closest_in_turn(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                              Hit* hits, Counts&... counts) {
  for (const Ray& ray : rays) new (hits++) Hit(closest(bvh, geometry, ray, counts...));
}

template <typename... Counts>
HWY_ATTR void any_in_turn(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                          std::uint8_t* hits, Counts&... counts) {
  for (const Ray& ray : rays) *hits++ = any(bvh, geometry, ray, counts...);
}

template <typename... Counts>
HWY_ATTR void closest_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                            Hit* hits, Counts&... counts) {
  Batch<ClosestQuery>(bvh, rays, hits).answer(geometry, steps_of(counts...));
}

template <typename... Counts>
HWY_ATTR void any_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                        std::uint8_t* hits, Counts&... counts) {
  Batch<AnyQuery>(bvh, rays, hits).answer(geometry, steps_of(counts...));
}

HWY_ATTR bool load(const Ray& ray, CheckedRay& checked) { return RayLoader::load(ray, checked); }

HWY_ATTR std::uint32_t intersect_boxes(const WideNode& node, const CheckedRay& ray, float t_max,
                                       float* entries) {
  alignas(32) float stored[WideNode::width];
  const std::uint32_t met = BoxRay(ray).intersect(node, t_max, stored);
  std::copy(std::begin(stored), std::end(stored), entries);
  return met;
}

/// Counts: none, or QueryCounts.
template <typename... Counts>
BasicWideKernel<Counts&...> kernel() {
  return {simd_name(hwy::TargetName(HWY_TARGET)),
          closest<Counts...>,
          any<Counts...>,
          closest_in_turn<Counts...>,
          any_in_turn<Counts...>,
          closest_batch<Counts...>,
          any_batch<Counts...>,
          load,
          intersect_boxes};
}

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray {
namespace {

/// The scalar traversal as a kernel.
struct Scalar {
  static Hit closest(const WideBvh& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_closest(bvh, geometry, ray, counts);
  }
  static bool any(const WideBvh& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_any(bvh, geometry, ray, counts);
  }
  static void closest_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                            Hit* hits) {
    for (const Ray& ray : rays) *hits++ = closest(bvh, geometry, ray);
  }
  static void any_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                        std::uint8_t* hits) {
    for (const Ray& ray : rays) *hits++ = any(bvh, geometry, ray);
  }
  static WideKernel kernel() {
    return {"scalar",      closest,   any,      closest_batch,     any_batch,
            closest_batch, any_batch, load_ray, intersect_children};
  }
};

/// Those that were compiled for an instruction set of this machine, the fastest first.
template <typename... Counts>
std::vector<BasicWideKernel<Counts&...>> fast_kernels() {
  std::vector<BasicWideKernel<Counts&...>> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, kernel<Counts...>());
  return kernels;
}

}  // namespace

std::vector<WideKernel> wide_kernels() {
  std::vector<WideKernel> kernels = fast_kernels<>();
  kernels.push_back(Scalar::kernel());
  return kernels;
}

std::vector<CountingWideKernel> counting_wide_kernels() { return fast_kernels<QueryCounts>(); }

}  // namespace twinray
#endif
