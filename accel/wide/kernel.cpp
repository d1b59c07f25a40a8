// SPDX-License-Identifier: Apache-2.0
// The queries over an eight-wide BVH, compiled once for each instruction set.
#include "accel/wide/kernel.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>

#include "accel/instruction_sets.h"
#include "accel/wide/scalar.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)  // no faster than the scalar kernel, and than AVX3
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

// The single queries have loops of their own: nothing else is there to be done while one waits for the number
// of children it meets, so there it is faster to guess.

HWY_ATTR Hit closest(const WideBvh& bvh, const Geometry& geometry, const Ray& given) {
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
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, t_max, entries);
      if (met == 0) break;
      ref = nearest_child(node, met, entries, top);
    }
    if (ref.is_block()) {
      block_ray.closest(geometry, ray, bvh.blocks[ref.index()], best);
      t_max = std::min(t_max, best.t);
    }
    ref = pop(stack, top, t_max);
    if (ref.is_none()) break;
  }
  hit = best.hit();
  ray.scale_back(hit);
  return hit;
}

HWY_ATTR bool any(const WideBvh& bvh, const Geometry& geometry, const Ray& given) {
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
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, ray.t_max, entries);
      if (met == 0) break;
      ref = any_child(node, met, top);
    }
    if (ref.is_block() && block_ray.any(geometry, ray, bvh.blocks[ref.index()])) return true;
    if (top == stack) return false;
    ref = {*--top};
  }
}

HWY_ATTR void closest_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                            Hit* hits) {
  Batch<ClosestQuery>(bvh, rays, hits).answer(geometry);
}

HWY_ATTR void any_batch(const WideBvh& bvh, const Geometry& geometry, std::span<const Ray> rays,
                        std::uint8_t* hits) {
  Batch<AnyQuery>(bvh, rays, hits).answer(geometry);
}

HWY_ATTR bool load(const Ray& ray, CheckedRay& checked) { return RayLoader::load(ray, checked); }

HWY_ATTR std::uint32_t meet(const WideNode& node, const CheckedRay& ray, float t_max, float* entries) {
  alignas(32) float stored[WideNode::width];
  const std::uint32_t met = BoxRay(ray).intersect(node, t_max, stored);
  std::copy(std::begin(stored), std::end(stored), entries);
  return met;
}

WideKernel kernel() {
  return {simd_name(hwy::TargetName(HWY_TARGET)), closest, any, closest_batch, any_batch, load, meet};
}

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace twinray {
namespace {

/// The scalar traversal as a kernel.
template <TriangleTest test>
struct Scalar {
  static Hit closest(const WideBvh& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_closest<test>(bvh, geometry, ray, counts);
  }
  static bool any(const WideBvh& bvh, const Geometry& geometry, const Ray& ray) {
    QueryCounts counts;
    return scalar_any<test>(bvh, geometry, ray, counts);
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
    return {"scalar", closest, any, closest_batch, any_batch, load_ray, scalar_meet};
  }
};

}  // namespace

std::vector<WideKernel> wide_kernels(TriangleTest test) {
  if (test == TriangleTest::moller_trumbore) return {Scalar<TriangleTest::moller_trumbore>::kernel()};
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
  kernels.push_back(Scalar<TriangleTest::woop>::kernel());
  return kernels;
}

}  // namespace twinray
#endif
