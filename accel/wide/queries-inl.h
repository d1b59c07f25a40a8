// SPDX-License-Identifier: Apache-2.0
// Private: the queries over an eight-wide BVH of any kind of tree, compiled once for each instruction set by
// the file that includes it for its kind.
#if defined(TWINRAY_ACCEL_WIDE_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_QUERIES_INL_H
#undef TWINRAY_ACCEL_WIDE_QUERIES_INL_H
#else
#define TWINRAY_ACCEL_WIDE_QUERIES_INL_H
#endif

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <new>
#include <span>

#include "accel/canonical/load_ray-inl.h"
#include "accel/counting.h"
#include "accel/wide/batch-inl.h"
#include "accel/wide/instanced-inl.h"
#include "accel/wide/kernel.h"
#include "accel/wide/packets-inl.h"
#include "accel/wide/stack-inl.h"
#include "core/instruction_sets.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

// The single queries have loops of their own: while one waits for the number of children that it hits there
// is nothing else to do, so a predicted branch is faster there.

/// What a single query of one space has found.
template <typename Tree>
struct Found {
  Nearest best;
  [[no_unique_address]] OpenLeaves<Tree> leaves;
};

/// The least hit of one space's tree: of what lies below `ref`, which there is. `enter` is called for the
/// instances on the way, with their number and t_max, and returns what is left of t_max.
template <typename Tree, typename Steps, typename Enter>
HWY_ATTR HWY_INLINE void find_closest(const Tree& bvh, const Geometry& geometry, WideRef ref,
                                      const CheckedRay& ray, Found<Tree>& found, const Steps& steps,
                                      const Enter& enter) {
  const BoxRay box_ray(ray);
  const BlockRay block_ray(ray);
  float t_max = ray.t_max;
  Key stack[Enter::stack_size];
  Key* top = stack;
  for (;;) {
    while (!ref.is_leaf()) {
      const typename Tree::Node& node = bvh.node(ref);
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, t_max, entries);
      if (met == 0) break;
      ref = nearest_child(node.children, met, entries, top);
    }
    if (ref.is_leaf()) {
      steps.visit_leaf();
      if (Enter::exist && ref.is_instance()) {
        t_max = enter(ref.index(), t_max);
      } else {
        const PrimitiveBlock& block = found.leaves.open(bvh, ref);
        steps.test_block(block);
        block_ray.closest(geometry, ray, block, found.best);
        found.leaves.keep(found.best);
        t_max = std::min(t_max, found.best.t);
      }
    }
    ref = pop(stack, top, t_max);
    if (ref.is_none()) break;
  }
}

/// Whether anything is hit, likewise; `enter` returns whether something of the instance is.
template <typename Tree, typename Steps, typename Enter>
HWY_ATTR HWY_INLINE bool find_any(const Tree& bvh, const Geometry& geometry, WideRef ref,
                                  const CheckedRay& ray, const Steps& steps, const Enter& enter) {
  const BoxRay box_ray(ray);
  const BlockRay block_ray(ray);
  OpenLeaves<Tree> leaves;
  std::uint32_t stack[Enter::stack_size];
  std::uint32_t* top = stack;
  for (;;) {
    while (!ref.is_leaf()) {
      const typename Tree::Node& node = bvh.node(ref);
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = box_ray.intersect(node, ray.t_max, entries);
      if (met == 0) break;
      ref = any_child(node.children, met, top);
    }
    if (ref.is_leaf()) {
      steps.visit_leaf();
      if (Enter::exist && ref.is_instance()) {
        if (enter(ref.index(), ray.t_max)) return true;
      } else {
        const PrimitiveBlock& block = leaves.open(bvh, ref);
        steps.test_block(block);
        if (block_ray.any(geometry, ray, block)) return true;
      }
    }
    if (top == stack) return false;
    ref = {*--top};
  }
}

/// For trees whose leaves are all blocks.
struct NoInstances {
  static constexpr bool exist = false;
  static constexpr int stack_size = wide_stack_size;

  float operator()(std::uint32_t, float t_max) const { return t_max; }
};

/// The way into the instances of a scene.
template <typename Tree>
struct Instances {
  static constexpr bool exist = true;
  static constexpr int stack_size = instanced_stack_size;

  const Tree& bvh;
  const Geometry& geometry;
  const CheckedRay& world;

  /// Loads the ray into an instance's space; false where there is nothing to be hit up to t_max.
  HWY_ATTR HWY_INLINE bool enter(std::uint32_t instance, float t_max, CheckedRay& own) const {
    return InstanceRayLoader::enter(geometry.placed(), instance, world, t_max, own);
  }
  WideRef root(std::uint32_t instance) const { return bvh.prototypes[geometry.placed()[instance].prototype]; }
};

template <typename Tree, typename Steps>
struct ClosestInInstances : Instances<Tree> {
  Hit& best;
  const Steps& steps;

  HWY_ATTR HWY_NOINLINE float operator()(std::uint32_t instance, float t_max) const {
    CheckedRay own;
    if (!this->enter(instance, t_max, own)) return t_max;
    steps.enter_instance();
    Found<Tree> found;
    find_closest(this->bvh, this->geometry, this->root(instance), own, found, steps, NoInstances());
    if (const Hit hit = found.best.hit(own); precedes(hit, best)) best = hit;
    return std::min(t_max, best.t);
  }
};

template <typename Tree, typename Steps>
struct AnyInInstances : Instances<Tree> {
  const Steps& steps;

  HWY_ATTR HWY_NOINLINE bool operator()(std::uint32_t instance, float t_max) const {
    CheckedRay own;
    if (!this->enter(instance, t_max, own)) return false;
    steps.enter_instance();
    return find_any(this->bvh, this->geometry, this->root(instance), own, steps, NoInstances());
  }
};

/// Queries over trees without instances.
template <typename Bvh>
struct Plain {
  using Tree = Bvh;
  using Closest = ClosestQuery<Tree>;
  using Any = AnyQuery<Tree>;

  template <typename Steps>
  static HWY_ATTR HWY_INLINE Hit closest(const Tree& bvh, const Geometry& geometry, const Ray& given,
                                         const Steps& steps) {
    Hit hit;  // The one variable that every path returns: it is written where it goes.
    CheckedRay ray;
    if (bvh.root.is_none() || !RayLoader::load(given, ray)) return hit;
    Found<Tree> found;
    find_closest(bvh, geometry, bvh.root, ray, found, steps, NoInstances());
    hit = found.best.hit(ray);
    ray.scale_back(hit);
    return hit;
  }
  template <typename Steps>
  static HWY_ATTR HWY_INLINE bool any(const Tree& bvh, const Geometry& geometry, const Ray& given,
                                      const Steps& steps) {
    CheckedRay ray;
    if (bvh.root.is_none() || !RayLoader::load(given, ray)) return false;
    return find_any(bvh, geometry, bvh.root, ray, steps, NoInstances());
  }
};

/// Over those with instances.
template <typename Bvh>
struct Instanced {
  using Tree = Bvh;
  using Closest = InstancedClosestQuery<Tree>;
  using Any = InstancedAnyQuery<Tree>;

  template <typename Steps>
  static HWY_ATTR HWY_INLINE Hit closest(const Tree& bvh, const Geometry& geometry, const Ray& given,
                                         const Steps& steps) {
    Hit hit;
    CheckedRay ray;
    if (bvh.root.is_none() || !InstanceRayLoader::load_world(geometry.placed(), given, ray)) return hit;
    Found<Tree> found;
    find_closest(bvh, geometry, bvh.root, ray, found, steps,
                 ClosestInInstances<Tree, Steps>{{bvh, geometry, ray}, hit, steps});
    if (const Hit direct = found.best.hit(ray); precedes(direct, hit)) hit = direct;
    ray.scale_back(hit);
    return hit;
  }
  template <typename Steps>
  static HWY_ATTR HWY_INLINE bool any(const Tree& bvh, const Geometry& geometry, const Ray& given,
                                      const Steps& steps) {
    CheckedRay ray;
    if (bvh.root.is_none() || !InstanceRayLoader::load_world(geometry.placed(), given, ray)) return false;
    return find_any(bvh, geometry, bvh.root, ray, steps,
                    AnyInInstances<Tree, Steps>{{bvh, geometry, ray}, steps});
  }
};

template <typename Queries, typename... Counts>
HWY_ATTR Hit closest(const typename Queries::Tree& bvh, const Geometry& geometry, const Ray& ray,
                     Counts&... counts) {
  return Queries::closest(bvh, geometry, ray, steps_of(counts...));
}

template <typename Queries, typename... Counts>
HWY_ATTR bool any(const typename Queries::Tree& bvh, const Geometry& geometry, const Ray& ray,
                  Counts&... counts) {
  return Queries::any(bvh, geometry, ray, steps_of(counts...));
}

// Without a call for each ray, and with each answer written where it goes, what many rays have in common is
// done once.

template <typename Queries, typename... Counts>
HWY_ATTR void closest_in_turn(const typename Queries::Tree& bvh, const Geometry& geometry,
                              std::span<const Ray> rays, Hit* hits, Counts&... counts) {
  const auto steps = steps_of(counts...);
  for (const Ray& ray : rays) new (hits++) Hit(Queries::closest(bvh, geometry, ray, steps));
}

template <typename Queries, typename... Counts>
HWY_ATTR void any_in_turn(const typename Queries::Tree& bvh, const Geometry& geometry,
                          std::span<const Ray> rays, std::uint8_t* hits, Counts&... counts) {
  const auto steps = steps_of(counts...);
  for (const Ray& ray : rays) *hits++ = Queries::any(bvh, geometry, ray, steps);
}

template <typename Queries, typename... Counts>
HWY_ATTR void closest_batch(const typename Queries::Tree& bvh, const Geometry& geometry,
                            std::span<const Ray> rays, Hit* hits, Counts&... counts) {
  Batch<typename Queries::Closest>(bvh, geometry, rays, hits).answer(steps_of(counts...));
}

template <typename Queries, typename... Counts>
HWY_ATTR void any_batch(const typename Queries::Tree& bvh, const Geometry& geometry,
                        std::span<const Ray> rays, std::uint8_t* hits, Counts&... counts) {
  Batch<typename Queries::Any>(bvh, geometry, rays, hits).answer(steps_of(counts...));
}

inline HWY_ATTR bool load(const Ray& ray, CheckedRay& checked) { return RayLoader::load(ray, checked); }

template <typename Node>
HWY_ATTR std::uint32_t intersect_boxes(const Node& node, const CheckedRay& ray, float t_max, float* entries) {
  alignas(32) float stored[WideNode::width];
  const std::uint32_t met = BoxRay(ray).intersect(node, t_max, stored);
  std::copy(std::begin(stored), std::end(stored), entries);
  return met;
}

/// Queries: Plain or Instanced; Counts: none, or QueryCounts.
template <typename Queries, typename... Counts>
BasicWideKernel<typename Queries::Tree, Counts&...> kernel() {
  return {simd_name(hwy::TargetName(HWY_TARGET)),
          closest<Queries, Counts...>,
          any<Queries, Counts...>,
          closest_in_turn<Queries, Counts...>,
          any_in_turn<Queries, Counts...>,
          closest_batch<Queries, Counts...>,
          any_batch<Queries, Counts...>,
          closest_in_packets<Queries, Counts...>,
          load,
          intersect_boxes<typename Queries::Tree::Node>};
}

template <typename Tree, typename... Counts>
BasicWideKernel<Tree, Counts&...> kernel_for(WideTrees trees) {
  return trees == WideTrees::instanced ? kernel<Instanced<Tree>, Counts...>()
                                       : kernel<Plain<Tree>, Counts...>();
}
template <typename Tree>
BasicWideKernel<Tree, QueryCounts&> counting_kernel_for(WideTrees trees) {
  return kernel_for<Tree, QueryCounts>(trees);
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
