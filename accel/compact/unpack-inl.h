// SPDX-License-Identifier: Apache-2.0
// Private: the nodes and leaves of a compact tree as the queries of accel/wide/ read them, compiled once for
// each instruction set.
#if defined(TWINRAY_ACCEL_WIDE_COMPACT_UNPACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_COMPACT_UNPACK_INL_H
#undef TWINRAY_ACCEL_WIDE_COMPACT_UNPACK_INL_H
#else
#define TWINRAY_ACCEL_WIDE_COMPACT_UNPACK_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "accel/compact/node.h"
#include "accel/wide/box_test-inl.h"
#include "accel/wide/open_leaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// With the bits of Grid::plane().
template <>
struct NodePlanes<CompactNode> : PlaneLanes {
  static HWY_ATTR HWY_INLINE Lanes load(const CompactNode& node, int axis, std::size_t place) {
    const hn::Rebind<std::uint8_t, Tag> bytes;
    const hn::Rebind<std::int32_t, Tag> integers;
    const auto steps = hn::PromoteTo(
        integers, hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(&node.planes) + place));
    return hn::Add(hn::Mul(hn::ConvertTo(Tag(), steps), hn::Set(Tag(), node.grids[axis].step)),
                   hn::Set(Tag(), node.grids[axis].origin));
  }
  static std::uint32_t children(const CompactNode& node) { return (1u << node.child_count) - 1; }
};

/// Unpacks a block that is not stored as it is: with the bits of unpacked() in the lanes that it uses; the
/// others have meaningless triangles.
class Unpacker {
 public:
  HWY_ATTR HWY_INLINE Unpacker(const std::uint16_t* words, const packed::Head& head)
      : words_(words), head_(head) {}

  HWY_ATTR HWY_INLINE void corners(PrimitiveBlock& block) const {
    std::size_t row = head_.vertex_word();
    for (int axis = 0; axis < 3; ++axis) {
      unpack_axis(axis, words_ + row, block);
      row += head_.axis_words(axis);
    }
  }
  HWY_ATTR HWY_INLINE void ids(PrimitiveBlock& block) const {
    if (head_.has_wide_ids) {
      std::memcpy(static_cast<void*>(block.ids), words_ + packed::ids_word,
                  head_.count * sizeof(PrimitiveId));
      return;
    }
    const std::uint32_t mesh = words_[3], least = packed::number_at(words_, 4);
    for (int lane = 0; lane < PrimitiveBlock::width;
         ++lane)  // What lies behind the last one is never asked for.
      block.ids[lane] = {mesh, least + words_[packed::ids_word + std::size_t(lane)]};
  }

 private:
  using Bits = hn::CappedTag<std::uint32_t, packed::max_vertices>;
  using Halves = hn::Rebind<std::uint16_t, Bits>;
  static constexpr std::size_t lane_count = hn::MaxLanes(Bits());

  /// The bits of vertices' coordinates from vertex `first` on.
  HWY_ATTR HWY_INLINE hn::Vec<Bits> vertices(int axis, const std::uint16_t* row, std::size_t first) const {
    // Both are read, for a branch would be mispredicted.
    const auto narrow = hn::PromoteTo(Bits(), hn::LoadU(Halves(), row + first));
    const hn::Repartition<std::uint16_t, Bits> words;
    const auto wide = hn::BitCast(Bits(), hn::LoadU(words, row + 2 * first));
    const auto is_wide = hn::Set(Bits(), 0u - (head_.wide_axes >> axis & 1));
    const auto least = hn::Set(Bits(), packed::number_at(words_, std::size_t(6 + 2 * axis)));
    return hn::Add(least, hn::Or(hn::And(is_wide, wide), hn::AndNot(is_wide, narrow)));
  }

  HWY_ATTR HWY_INLINE void unpack_axis(int axis, const std::uint16_t* row, PrimitiveBlock& block) const {
#if HWY_TARGET <= HWY_AVX2
    const hn::FixedTag<float, 8> floats;
    const auto all = hn::BitCast(floats, vertices(axis, row, 0));
    for (int corner = 0; corner < 3; ++corner) {
      const auto places = hn::IndicesFromVec(floats, places_of(words_[corner]));
      hn::Store(hn::LowerHalf(hn::TableLookupLanes(all, places)), hn::FixedTag<float, 4>(),
                block.corners[corner][axis]);
    }
#else
    alignas(32) std::uint32_t all[packed::max_vertices];
    for (std::size_t first = 0; first < packed::max_vertices; first += lane_count)
      hn::Store(vertices(axis, row, first), Bits(), all + first);
    for (int corner = 0; corner < 3; ++corner)
      for (int lane = 0; lane < PrimitiveBlock::width; ++lane)
        block.corners[corner][axis][lane] = std::bit_cast<float>(all[words_[corner] >> (3 * lane) & 7]);
#endif
  }

#if HWY_TARGET <= HWY_AVX2
  /// The places of a corner's vertices in lanes 0 to 3; what is in the others does not matter.
  static HWY_ATTR HWY_INLINE hn::Vec<Bits> places_of(std::uint32_t word) {
    alignas(32) static constexpr std::uint32_t shifts[8] = {0, 3, 6, 9, 0, 0, 0, 0};
    return hn::And(hn::Shr(hn::Set(Bits(), word), hn::Load(Bits(), shifts)), hn::Set(Bits(), 7));
  }
#endif

  const std::uint16_t* words_;
  const packed::Head& head_;
};

/// Two blocks: the one that holds the nearest hit, and the one that is looked at.
template <>
class OpenLeaves<CompactBvh> {
 public:
  OpenLeaves() {}  // Without values for what is written before it is read.

  HWY_ATTR HWY_INLINE const PrimitiveBlock& open(const CompactBvh& bvh, WideRef leaf) {
    const std::uint16_t* const words = bvh.packed(leaf);
    const packed::Head head(words);
    PrimitiveBlock& block = places_[free_].block;
    if (HWY_UNLIKELY(head.is_verbatim)) {
      std::memcpy(static_cast<void*>(&block), words + packed_unit, sizeof block);
      return block;
    }
    const std::uint32_t lanes = (1u << head.count) - 1;
    block.count = std::uint16_t(head.count);
    block.cut_outs = std::uint16_t(head.is_cut_out ? lanes : 0);
    block.triangles = head.is_cut_out ? 0 : lanes;
    block.others = head.is_cut_out ? lanes : 0;
    block.spheres = 0;
    const Unpacker unpacker(words, head);
    unpacker.ids(block);
    unpacker.corners(block);
    return block;
  }
  HWY_ATTR HWY_INLINE void keep(const Nearest& best) { free_ ^= best.block == &places_[free_].block; }
  static HWY_ATTR HWY_INLINE void prefetch(const CompactBvh& bvh, WideRef leaf) {
    // Two lines hold nearly all of them; behind the last vertex of an axis a third is read, too.
    prefetch_bytes<3 * 64>(bvh.packed(leaf));
  }

 private:
  union Place {
    PrimitiveBlock block;
    Place() {}
  };

  Place places_[2];
  std::uint32_t free_ = 0;
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
