// SPDX-License-Identifier: Apache-2.0
// Private: packets of rays through an eight-wide BVH, compiled once for each instruction set.
//
// Sixteen rays that run close together, such as those through one pixel, share each visit of a node: one test
// of its eight boxes, by bounds of all rays, that culls none which one of them intersects. So each ray gets
// the answer that it gets alone. Where the rays part, too many blocks are tested for the sake of one: then
// the packet is given up.
#if defined(TWINRAY_ACCEL_WIDE_PACKETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#undef TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#else
#define TWINRAY_ACCEL_WIDE_PACKETS_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <span>

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

/// A packet is given up that would test more primitives than this. 32 and 80 are as fast in most scenes; for
/// the cow 32 is slower, 80 for a dragon.
constexpr int most_primitives = 48;

/// The nearest hits of a packet; false where it is given up.
template <typename Tree, typename Steps>
HWY_ATTR HWY_INLINE bool find_closest(const Tree& bvh, const Geometry& geometry, const RayPacket& rays,
                                      Hit* hits, const Steps& steps) {
  const PacketBoxes boxes(rays);
  PacketHits nearest(rays);
  OpenLeaves<Tree> leaves;
  int tested = 0;
  Key stack[wide_stack_size];
  stack[0] = bottom;
  stack[1] = bvh.root.bits;
  Key* top = stack + 2;
  for (;;) {
    const WideRef next = pop_to_bottom(top, nearest.latest());
    if (next.is_none()) break;
    if (next.is_leaf()) {
      const PrimitiveBlock& block = leaves.open(bvh, next);
      tested += block.count;
      if (tested > most_primitives) return false;
      steps.visit_leaf();
      steps.test_block(block);
      nearest.test(geometry, rays, block);
    } else {
      const typename Tree::Node& node = bvh.node(next);
      steps.visit_node(node);
      alignas(32) float entries[WideNode::width];
      const std::uint32_t met = boxes.intersect(node, nearest.latest(), entries);
      push_sorted(node.children, met, entries, top);
    }
  }
  for (std::size_t i = 0; i < PacketLanes::packet_size; ++i) hits[i] = nearest.hit(i);
  return true;
}

/// Answers the first rays, packet by packet, as long as each is one and is not given up; returns how many are
/// answered. There are no packets through instances.
template <typename Queries, typename... Counts>
HWY_ATTR std::size_t closest_in_packets(const typename Queries::Tree& bvh, const Geometry& geometry,
                                        std::span<const Ray> rays, Hit* hits, Counts&... counts) {
  constexpr std::size_t size = PacketLanes::packet_size;
  if (Queries::Closest::has_instances || bvh.root.is_none()) return 0;
  const auto steps = steps_of(counts...);
  const Aabb& bounds = geometry.bounds();
  const float close = max_abs(bounds.upper - bounds.lower) / 64;
  std::size_t answered = 0;
  for (; answered + size <= rays.size(); answered += size) {
    RayPacket packet;
    if (!RayPacket::may_be(&rays[answered], close) || !packet.load(&rays[answered]) ||
        !find_closest(bvh, geometry, packet, hits + answered, steps))
      break;
  }
  return answered;
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
