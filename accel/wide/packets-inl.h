// SPDX-License-Identifier: Apache-2.0
// Private: packets of rays through an eight-wide BVH, compiled once for each instruction set.
//
// Sixteen rays that run close together, such as those through one pixel, share each visit of a node: one test
// of its eight boxes, by bounds of all rays, that culls none which one of them intersects. So each ray gets
// the answer that it gets alone. An instance takes all of them to its space at once. Where the rays part, too
// many blocks are tested for the sake of one: then the packet is given up.
#if defined(TWINRAY_ACCEL_WIDE_PACKETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#undef TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#else
#define TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/canonical/instance_packet-inl.h"
#include "accel/canonical/packet_test-inl.h"
#include "accel/counting.h"
#include "accel/wide/box_test-inl.h"
#include "accel/wide/open_leaves-inl.h"
#include "accel/wide/stack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// What BoxRay is for a ray, for a packet: the box of each child that one of its rays intersects is met, and
/// entered no later.
class PacketBoxes : public BoxTest<PacketBoxes> {
 public:
  HWY_ATTR HWY_INLINE explicit PacketBoxes(const RayPacket& rays) : BoxTest(rays.least_t_min) {
    for (int axis = 0; axis < 3; ++axis) {
      const PacketAxis& slab = rays.slab[axis];
      near_origin_[axis] = hn::Set(Tag(), slab.near_origin);
      far_origin_[axis] = hn::Set(Tag(), slab.far_origin);
      for (int end = 0; end < 2; ++end) {
        near_inverse_[axis][end] = hn::Set(Tag(), slab.near_inverse[end]);
        far_inverse_[axis][end] = hn::Set(Tag(), slab.far_inverse[end]);
      }
      set_rows(axis, slab.is_negative);
    }
  }

 private:
  friend BoxTest;

  HWY_ATTR HWY_INLINE Lanes near_at(int axis, Lanes planes) const {
    const Lanes distance = hn::Sub(planes, near_origin_[axis]);
    return hn::Min(hn::Mul(distance, near_inverse_[axis][0]), hn::Mul(distance, near_inverse_[axis][1]));
  }
  HWY_ATTR HWY_INLINE Lanes far_at(int axis, Lanes planes) const {
    const Lanes distance = hn::Sub(planes, far_origin_[axis]);
    return hn::Max(hn::Mul(distance, far_inverse_[axis][0]), hn::Mul(distance, far_inverse_[axis][1]));
  }

  Lanes near_origin_[3], far_origin_[3], near_inverse_[3][2], far_inverse_[3][2];
};

/// A packet is given up that would test more primitives than this in the scene's space. 32 and 80 are as fast
/// in most scenes; for the cow 32 is slower, 80 for a dragon.
constexpr int most_primitives = 48;
/// The same in an instance's space: what has been done is more. In a wood at 480 x 360, 96 is slower by a
/// tenth.
constexpr int most_primitives_in_instance = 200;

/// Finds the nearest hits of a packet in one space's tree; false where it is given up. `others` knows what
/// lies in other spaces: it is called for the instances on the way, and says up to which t a ray looks on.
template <typename Tree, typename Steps, typename Others>
HWY_ATTR HWY_INLINE bool find_closest(const Tree& bvh, const Geometry& geometry, WideRef root,
                                      const RayPacket& rays, PacketHits& nearest, const Steps& steps,
                                      Others& others) {
  const PacketBoxes boxes(rays);
  OpenLeaves<Tree> leaves;
  int tested = 0;
  float latest = nearest.latest();
  Key stack[Others::stack_size];
  stack[0] = bottom;
  stack[1] = root.bits;
  Key* top = stack + 2;
  for (;;) {
    const WideRef next = pop_to_bottom(top, latest);
    if (next.is_none()) return true;
    if (!next.is_leaf()) {
      const typename Tree::Node& node = bvh.node(next);
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = boxes.intersect(node, latest, entries);
      push_sorted(node.children, met, entries, top);
      continue;
    }
    steps.visit_leaf();
    if (Others::exist && next.is_instance()) {
      if (!others.enter(next.index())) return false;
    } else {
      const PrimitiveBlock& block = leaves.open(bvh, next);
      tested += block.count;
      if (tested > Others::most_primitives) return false;
      steps.test_block(block);
      nearest.test(geometry, rays, block);
    }
    latest = others.latest(nearest);
  }
}

/// There are none.
template <int most>
struct NoOtherSpaces {
  static constexpr bool exist = false;
  static constexpr int stack_size = wide_stack_size, most_primitives = most;

  bool enter(std::uint32_t) { return true; }
  float latest(const PacketHits& nearest) const { return nearest.latest(); }
};

/// What the rays of a packet hit in instances.
template <typename Tree, typename Steps>
class PacketInInstances : PacketLanes {
 public:
  static constexpr bool exist = true;
  static constexpr int stack_size = instanced_stack_size, most_primitives = HWY_NAMESPACE::most_primitives;

  HWY_ATTR HWY_INLINE PacketInInstances(const Tree& bvh, const Geometry& geometry, const WorldPacket& world,
                                        const Steps& steps)
      : bvh_(bvh), geometry_(geometry), world_(world), steps_(steps), t_max_(world.packet().t_max) {}

  /// Looks for hits in an instance; false where the packet is given up.
  HWY_ATTR HWY_NOINLINE bool enter(std::uint32_t instance) {
    RayLanes rays;
    RayPacket own;
    switch (world_.enter(geometry_.placed(), instance, t_max_, rays, own)) {
      case WorldPacket::Entry::missed:
        return true;
      case WorldPacket::Entry::parted:
        return false;
      case WorldPacket::Entry::entered:
        break;
    }
    steps_.enter_instance();
    const WideRef root = bvh_.prototypes[geometry_.placed()[instance].prototype];
    PacketHits nearest(own);
    NoOtherSpaces<most_primitives_in_instance> none;
    if (!find_closest(bvh_, geometry_, root, own, nearest, steps_, none)) return false;
    for (std::uint32_t left = nearest.found(); left != 0; left &= left - 1) {
      const auto ray = std::size_t(std::countr_zero(left));
      const Hit hit = nearest.hit(ray);
      if (!precedes(hit, best_[ray])) continue;
      best_[ray] = hit;
      t_max_.values[ray] = hit.t;
    }
    return true;
  }
  /// Up to which t a ray looks on that has hit this in the scene's space; what is nearer there lowers t_max
  /// in instances, too.
  HWY_ATTR HWY_INLINE float latest(const PacketHits& direct) {
    Range range;
    for (std::size_t i = 0; i < packet_size; i += lane_count) {
      t_max_.set(i, hn::Min(t_max_.at(i), direct.t_max().at(i)));
      range.add(i, t_max_.at(i));
    }
    return range.largest();
  }
  const Hit& best(std::size_t ray) const { return best_[ray]; }

 private:
  const Tree& bvh_;
  const Geometry& geometry_;
  const WorldPacket& world_;
  const Steps& steps_;
  Hit best_[packet_size];
  Numbers t_max_;
};

/// The hits of sixteen rays in a tree without instances; false where they are no packet, or it is given up.
template <typename Tree, typename Steps>
HWY_ATTR HWY_INLINE bool closest_in_packet(const Tree& bvh, const Geometry& geometry, const Ray* given,
                                           Hit* hits, const Steps& steps) {
  RayLanes lanes;
  RayPacket rays;
  if (!lanes.load(given) || !rays.load(lanes)) return false;
  PacketHits nearest(rays);
  NoOtherSpaces<most_primitives> none;
  if (!find_closest(bvh, geometry, bvh.root, rays, nearest, steps, none)) return false;
  for (std::size_t i = 0; i < PacketLanes::packet_size; ++i) hits[i] = nearest.hit(i);
  return true;
}

/// The same in a tree with instances.
template <typename Tree, typename Steps>
HWY_ATTR HWY_INLINE bool closest_in_world_packet(const Tree& bvh, const Geometry& geometry, const Ray* given,
                                                 Hit* hits, const Steps& steps) {
  WorldPacket world;
  if (!world.load(geometry.placed(), given)) return false;
  PacketHits nearest(world.packet());
  PacketInInstances<Tree, Steps> instances(bvh, geometry, world, steps);
  if (!find_closest(bvh, geometry, bvh.root, world.packet(), nearest, steps, instances)) return false;
  for (std::size_t i = 0; i < PacketLanes::packet_size; ++i) {
    const Hit direct = nearest.hit(i);
    hits[i] = world.scaled_back(precedes(direct, instances.best(i)) ? direct : instances.best(i), i);
  }
  return true;
}

/// Answers the first rays, packet by packet, as long as each is one and is not given up; returns how many are
/// answered.
template <typename Queries, typename... Counts>
HWY_ATTR std::size_t closest_in_packets(const typename Queries::Tree& bvh, const Geometry& geometry,
                                        std::span<const Ray> rays, Hit* hits, Counts&... counts) {
  constexpr std::size_t size = PacketLanes::packet_size;
  if (bvh.root.is_none()) return 0;
  const auto steps = steps_of(counts...);
  const Aabb& bounds = geometry.bounds();
  const float close = max_abs(bounds.upper - bounds.lower) / 64;
  std::size_t answered = 0;
  for (; answered + size <= rays.size(); answered += size) {
    const Ray* const given = &rays[answered];
    if (!RayPacket::may_be(given, close)) break;
    const bool is_answered = [&]() HWY_ATTR {
      if constexpr (Queries::Closest::has_instances)
        return closest_in_world_packet(bvh, geometry, given, hits + answered, steps);
      else
        return closest_in_packet(bvh, geometry, given, hits + answered, steps);
    }();
    if (!is_answered) break;
  }
  return answered;
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
