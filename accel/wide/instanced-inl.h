// SPDX-License-Identifier: Apache-2.0
// Private: the queries of a batch (batch-inl.h) over a scene with instances, compiled once for each
// instruction set.
//
// A query is in one space at a time: in the scene's or in that of an instance. On its stack a mark lies below
// what waits in the instance; the query is back in the scene when it finds the mark.
#if defined(TWINRAY_ACCEL_WIDE_INSTANCED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_INSTANCED_INL_H
#undef TWINRAY_ACCEL_WIDE_INSTANCED_INL_H
#else
#define TWINRAY_ACCEL_WIDE_INSTANCED_INL_H
#endif

#include <algorithm>
#include <cstdint>
#include <new>

#include "accel/canonical/instance_ray-inl.h"
#include "accel/wide/batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A closest-hit query on its way through a scene with instances.
template <typename Bvh>
class InstancedClosestQuery {
 public:
  using Tree = Bvh;
  using Answer = Hit;
  static constexpr bool has_instances = true;

  /// False for an invalid ray.
  HWY_ATTR HWY_INLINE bool start(const Geometry& geometry, const Ray& given, WideRef root) {
    if (!InstanceRayLoader::load_world(geometry.placed(), given, rays_[0])) return false;
    space_ = 0;
    best_ = {};
    new (&nearest_) Nearest;  // Without a value for what has none yet.
    t_max_ = rays_[0].t_max;
    stack_[0] = bottom;
    stack_[1] = root.bits;
    top_ = stack_ + 2;
    return true;
  }
  /// Takes what comes next from the stack; none where the query is answered.
  HWY_ATTR HWY_INLINE WideRef advance() {
    next_ = pop_to_bottom(top_, t_max_);
    if (next_.is_none() && space_ == 1) {
      leave();
      next_ = pop_to_bottom(top_, t_max_);
    }
    return next_;
  }
  /// What it was.
  WideRef next() const { return next_; }

  HWY_ATTR HWY_INLINE void visit(const typename Tree::Node& node) {
    alignas(32) float entries[WideNode::width];
    const std::uint32_t met = BoxRay(rays_[space_]).intersect(node, t_max_, entries);
    push_sorted(node.children, met, entries, top_);
  }
  template <typename Steps>
  HWY_ATTR HWY_INLINE void visit_leaf(const Tree& bvh, const Geometry& geometry, const Steps& steps) {
    const PrimitiveBlock& block = leaves_.open(bvh, next_);
    steps.test_block(block);
    BlockRay(rays_[space_]).closest(geometry, rays_[space_], block, nearest_);
    leaves_.keep(nearest_);
    t_max_ = std::min(t_max_, nearest_.t);
  }
  /// Goes on in the instance that next() is; false where there is nothing to be hit in it.
  HWY_ATTR HWY_INLINE bool enter(const PlacedInstances& placed, WideRef root) {
    if (!InstanceRayLoader::enter(placed, next_.index(), rays_[0], t_max_, rays_[1])) return false;
    keep_nearest();
    space_ = 1;
    t_max_ = rays_[1].t_max;
    *top_++ = bottom;
    *top_++ = root.bits;
    return true;
  }
  Hit answer() {
    keep_nearest();
    rays_[0].scale_back(best_);
    return best_;
  }

 private:
  HWY_ATTR HWY_INLINE void leave() {
    keep_nearest();
    space_ = 0;
    t_max_ = std::min(rays_[0].t_max, best_.t);
  }
  /// Ends the search in a space.
  HWY_ATTR HWY_INLINE void keep_nearest() {
    if (nearest_.t == Aabb::infinity) return;
    if (const Hit hit = nearest_.hit(rays_[space_]); precedes(hit, best_)) best_ = hit;
    new (&nearest_) Nearest;
  }

  CheckedRay rays_[2];  ///< In the scene, and in the instance.
  int space_;           ///< Which of them it is.
  Hit best_;            ///< Of the spaces before.
  Nearest nearest_;     ///< Of this one.
  [[no_unique_address]] OpenLeaves<Tree> leaves_;
  float t_max_;
  WideRef next_;
  Key* top_;
  Key stack_[instanced_stack_size];
};

/// An any-hit query, likewise.
template <typename Bvh>
class InstancedAnyQuery {
 public:
  using Tree = Bvh;
  using Answer = std::uint8_t;
  static constexpr bool has_instances = true;

  HWY_ATTR HWY_INLINE bool start(const Geometry& geometry, const Ray& given, WideRef root) {
    if (!InstanceRayLoader::load_world(geometry.placed(), given, rays_[0])) return false;
    space_ = 0;
    is_hit_ = false;
    stack_[0] = WideRef::no_child;
    stack_[1] = root.bits;
    top_ = stack_ + 2;
    return true;
  }
  HWY_ATTR HWY_INLINE WideRef advance() {
    next_ = {*--top_};
    if (next_.is_none() && space_ == 1) {
      space_ = 0;
      next_ = {*--top_};
    }
    return next_;
  }
  WideRef next() const { return next_; }

  HWY_ATTR HWY_INLINE void visit(const typename Tree::Node& node) {
    alignas(32) float entries[WideNode::width];
    const std::uint32_t met = BoxRay(rays_[space_]).intersect(node, rays_[space_].t_max, entries);
    push_all(node.children, met, top_);
  }
  template <typename Steps>
  HWY_ATTR HWY_INLINE void visit_leaf(const Tree& bvh, const Geometry& geometry, const Steps& steps) {
    OpenLeaves<Tree> leaves;
    const PrimitiveBlock& block = leaves.open(bvh, next_);
    steps.test_block(block);
    is_hit_ = BlockRay(rays_[space_]).any(geometry, rays_[space_], block);
    if (!is_hit_) return;
    space_ = 0;  // Nothing is next then.
    top_ = stack_ + 1;
  }
  HWY_ATTR HWY_INLINE bool enter(const PlacedInstances& placed, WideRef root) {
    if (!InstanceRayLoader::enter(placed, next_.index(), rays_[0], rays_[0].t_max, rays_[1])) return false;
    space_ = 1;
    *top_++ = WideRef::no_child;
    *top_++ = root.bits;
    return true;
  }
  bool answer() const { return is_hit_; }

 private:
  CheckedRay rays_[2];
  int space_;
  bool is_hit_;
  WideRef next_;
  std::uint32_t* top_;
  std::uint32_t stack_[instanced_stack_size];
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
