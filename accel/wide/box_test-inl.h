// SPDX-License-Identifier: Apache-2.0
// Private: the test of a node's eight boxes, compiled once for each instruction set.
//
// Eight boxes are tested at once by the operations of accel/canonical/slab.h, in their order and without
// fused multiply-add, so each lane has the bits of intersect_slab and what its monotony promises holds: no
// box is culled that holds an accepted hit.
#if defined(TWINRAY_ACCEL_WIDE_BOX_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_BOX_TEST_INL_H
#undef TWINRAY_ACCEL_WIDE_BOX_TEST_INL_H
#else
#define TWINRAY_ACCEL_WIDE_BOX_TEST_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/block_test-inl.h"
#include "accel/canonical/checked_ray.h"
#include "accel/wide/node.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// The vectors in which a node's boxes are tested: up to eight planes of one row.
struct PlaneLanes {
  using Tag = hn::CappedTag<float, WideNode::width>;
  using Lanes = hn::Vec<Tag>;
  static constexpr std::size_t lane_count = hn::MaxLanes(Tag());
};

/// How the planes of a node are read. A node of another kind has a specialisation.
template <typename Node>
struct NodePlanes : PlaneLanes {
  /// Those across an axis, from a place in the node's table of planes on.
  static HWY_ATTR HWY_INLINE Lanes load(const Node& node, int /*axis*/, std::size_t place) {
    return hn::Load(Tag(), reinterpret_cast<const float*>(&node.planes) + place);  // Of the whole table.
  }
  /// Bit i: there is a child i. No empty box is intersected, so it need not be asked here.
  static std::uint32_t children(const Node&) { return ~0u; }
};

/// The test of a node's boxes. Self has near_at(axis, planes) and far_at(axis, planes): at which t planes
/// across an axis are met where they are the near ones, or the far ones.
template <typename Self>
class BoxTest : protected PlaneLanes {
 public:
  /// Bit i: the box of child i is met within [t_min, t_max], first at entries[i], which is never -0.
  template <typename Node>
  HWY_ATTR HWY_INLINE std::uint32_t intersect(const Node& node, float t_max, float* entries) const {
    const Lanes exit_limit = hn::Set(Tag(), t_max);
    std::uint32_t met = 0;
    for (std::size_t first = 0; first < WideNode::width; first += lane_count) {
      // Two levels instead of three: a traversal waits for the last of them.
      const auto nearest = hn::BitCast(IntTag(), hn::Max(near_at(node, 0, first), near_at(node, 1, first)));
      const auto at_least = hn::Max(hn::BitCast(IntTag(), near_at(node, 2, first)), t_min_);
      const Lanes exit = hn::Min(hn::Min(far_at(node, 0, first), far_at(node, 1, first)),
                                 hn::Min(far_at(node, 2, first), exit_limit));
      // The maximum with a number >= +0 as integers is that as floats, and never -0.
      const Lanes entry = hn::BitCast(Tag(), hn::Max(nearest, at_least));
      hn::Store(entry, Tag(), entries + first);
      met |= bits_of(Tag(), hn::Le(entry, exit)) << first;
    }
    return met & NodePlanes<Node>::children(node);
  }

 protected:
  HWY_ATTR HWY_INLINE explicit BoxTest(float t_min)
      : t_min_(hn::Set(IntTag(), std::bit_cast<std::int32_t>(t_min + 0.0f))) {}
  /// By the sign of the direction's component.
  HWY_ATTR HWY_INLINE void set_rows(int axis, bool is_negative) {
    near_row_[axis] = std::size_t(2 * axis + is_negative) * WideNode::width;
    far_row_[axis] = near_row_[axis] ^ WideNode::width;
  }

 private:
  using IntTag = hn::RebindToSigned<Tag>;

  template <typename Node>
  HWY_ATTR HWY_INLINE Lanes near_at(const Node& node, int axis, std::size_t first) const {
    const Lanes planes = NodePlanes<Node>::load(node, axis, near_row_[axis] + first);
    return static_cast<const Self&>(*this).near_at(axis, planes);
  }
  template <typename Node>
  HWY_ATTR HWY_INLINE Lanes far_at(const Node& node, int axis, std::size_t first) const {
    const Lanes planes = NodePlanes<Node>::load(node, axis, far_row_[axis] + first);
    return static_cast<const Self&>(*this).far_at(axis, planes);
  }

  hn::Vec<IntTag> t_min_;
  std::size_t near_row_[3], far_row_[3];  ///< Where in a node's planes they are.
};

/// A ray in the form that the box test needs: in lanes, with its octant as places of rows in a node.
class BoxRay : public BoxTest<BoxRay> {
 public:
  HWY_ATTR HWY_INLINE explicit BoxRay(const CheckedRay& ray) : BoxTest(ray.t_min) {
    for (int axis = 0; axis < 3; ++axis) {
      near_origin_[axis] = hn::Set(Tag(), ray.near_origin[axis]);
      far_origin_[axis] = hn::Set(Tag(), ray.far_origin[axis]);
      near_inverse_[axis] = hn::Set(Tag(), ray.near_inverse[axis]);
      far_inverse_[axis] = hn::Set(Tag(), ray.far_inverse[axis]);
      set_rows(axis, ray.is_negative[axis] != 0);
    }
  }

 private:
  friend BoxTest;

  HWY_ATTR HWY_INLINE Lanes near_at(int axis, Lanes planes) const {
    return hn::Mul(hn::Sub(planes, near_origin_[axis]), near_inverse_[axis]);
  }
  HWY_ATTR HWY_INLINE Lanes far_at(int axis, Lanes planes) const {
    return hn::Mul(hn::Sub(planes, far_origin_[axis]), far_inverse_[axis]);
  }

  Lanes near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3];
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
