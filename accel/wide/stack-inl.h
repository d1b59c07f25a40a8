// SPDX-License-Identifier: Apache-2.0
// Private: the children that wait while a ray is on its way through an eight-wide BVH, compiled once for each
// instruction set. A node's children are given as an array of WideNode::width, aligned to 32 bytes.
#if defined(TWINRAY_ACCEL_WIDE_STACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_STACK_INL_H
#undef TWINRAY_ACCEL_WIDE_STACK_INL_H
#else
#define TWINRAY_ACCEL_WIDE_STACK_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "accel/canonical/block_test-inl.h"
#include "accel/wide/box_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// A child that waits on the stack: the bits of its entry above its name. Entries are not negative, so these
/// numbers are ordered as entries are.
using Key = std::uint64_t;

HWY_ATTR HWY_INLINE Key key_of(const float* entries, const WideRef* children, int child) {
  return Key(std::bit_cast<std::uint32_t>(entries[child])) << 32 | children[child].bits;
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

/// The nearest of the children that the ray intersects, at least one; the others wait on the stack, the
/// nearer the higher.
HWY_ATTR HWY_INLINE WideRef nearest_child(const WideRef* children, std::uint32_t met, const float* entries,
                                          Key*& top) {
  const int first = std::countr_zero(met);
  met &= met - 1;
  if (met == 0) return children[first];
  Key key = key_of(entries, children, first), other = key_of(entries, children, std::countr_zero(met));
  met &= met - 1;
  if (met == 0) {
    order(other, key);
    *top++ = other;
    return {std::uint32_t(key)};
  }
  Key* const lowest = top;
  *top++ = key;
  *top++ = other;
  for (; met != 0; met &= met - 1) *top++ = key_of(entries, children, std::countr_zero(met));
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

/// Lies at the bottom of a stack: no child, entered before any t_max.
constexpr Key bottom = WideRef::no_child;

/// The same of a stack with `bottom` in it: 5 % faster in batches, and 2 % slower for single rays.
HWY_ATTR HWY_INLINE WideRef pop_to_bottom(Key*& top, float t_max) {
  const std::uint32_t limit = std::bit_cast<std::uint32_t>(t_max + 0.0f);
  Key key = *--top;
  while (key >> 32 > limit) key = *--top;
  return {std::uint32_t(key)};
}

#if HWY_TARGET <= HWY_AVX3
/// All keys of a node in one vector.
using KeysTag = hn::FixedTag<Key, WideNode::width>;
using Keys = hn::Vec<KeysTag>;

/// Orders each lane and its partner: the larger key goes where the mask is false.
template <typename Mask>
HWY_ATTR HWY_INLINE Keys ordered(Keys keys, Keys partners, Mask is_smaller) {
  return hn::IfThenElse(is_smaller, hn::Min(keys, partners), hn::Max(keys, partners));
}

/// Sorts the lanes, the largest first, by Batcher's bitonic network.
HWY_ATTR HWY_INLINE Keys sorted(Keys keys) {
  static constexpr std::uint8_t odd_bits[8] = {0b10101010}, odd_pairs_bits[8] = {0b11001100};
  static constexpr std::uint8_t upper_bits[8] = {0b11110000};
  const KeysTag tag;
  const auto odd = hn::LoadMaskBits(tag, odd_bits), odd_pairs = hn::LoadMaskBits(tag, odd_pairs_bits);
  const auto upper = hn::LoadMaskBits(tag, upper_bits);
  keys = ordered(keys, hn::Reverse2(tag, keys), odd);
  keys = ordered(keys, hn::Reverse4(tag, keys), odd_pairs);
  keys = ordered(keys, hn::Reverse2(tag, keys), odd);
  keys = ordered(keys, hn::Reverse8(tag, keys), upper);
  keys = ordered(keys, hn::SwapAdjacentBlocks(keys), odd_pairs);
  return ordered(keys, hn::Reverse2(tag, keys), odd);
}
#endif

/// Puts the children that the ray intersects on the stack, the nearer the higher; of its places `top` and the
/// seven behind it may be written.
HWY_ATTR HWY_INLINE void push_sorted(const WideRef* children, std::uint32_t met, const float* entries,
                                     Key*& top) {
#if HWY_TARGET <= HWY_AVX3
  // All eight: a branch on how many are hit is mispredicted. Those that are not come last, and are
  // overwritten.
  const hn::FixedTag<std::uint32_t, WideNode::width> halves;
  const std::uint8_t bits[8] = {std::uint8_t(met)};
  const auto entry = hn::BitCast(halves, hn::Load(hn::FixedTag<float, WideNode::width>(), entries));
  const auto name = hn::Load(halves, &children[0].bits);
  const Keys keys =
      hn::Or(hn::ShiftLeft<32>(hn::PromoteTo(KeysTag(), entry)), hn::PromoteTo(KeysTag(), name));
  const auto is_met = hn::LoadMaskBits(KeysTag(), bits);
  hn::StoreU(sorted(hn::IfThenElseZero(is_met, keys)), KeysTag(), top);
  top += std::popcount(met);
#else
  if (met == 0) return;
  const WideRef nearest = nearest_child(children, met, entries, top);
  *top++ = nearest.bits;  // It is taken before t_max can change: its entry does not matter.
#endif
}

/// Puts children of a node on the stack, of whose places `top` and the seven behind it may be written.
HWY_ATTR HWY_INLINE void push(const WideRef* children, std::uint32_t chosen, std::uint32_t*& top) {
#if HWY_TARGET <= HWY_AVX3
  // All at once, for the end of a loop is mispredicted: 10 % on shadow rays. What other sets of instructions
  // take for it is slower than the loop.
  const hn::FixedTag<std::uint32_t, WideNode::width> tag;
  const std::uint8_t bits[8] = {std::uint8_t(chosen)};
  hn::StoreU(hn::CompressBits(hn::Load(tag, &children[0].bits), bits), tag, top);
  top += std::popcount(chosen);
#else
  for (; chosen != 0; chosen &= chosen - 1) *top++ = children[std::countr_zero(chosen)].bits;
#endif
}

/// The first of the children that the ray intersects; the others wait on the stack, as they come: to sort
/// them by distance took longer than the blocks that it saved, 8 % on shadow rays.
HWY_ATTR HWY_INLINE WideRef any_child(const WideRef* children, std::uint32_t met, std::uint32_t*& top) {
  const WideRef child = children[std::countr_zero(met)];
  met &= met - 1;
  if (met != 0) push(children, met, top);
  return child;
}

/// The same with all children that the ray intersects on the stack, the first on top.
HWY_ATTR HWY_INLINE void push_all(const WideRef* children, std::uint32_t met, std::uint32_t*& top) {
  constexpr std::uint32_t last = 1u << (WideNode::width - 1);  // Some child, where none is hit.
  push(children, met & (met - 1), top);
  *top = children[std::countr_zero(met | last)].bits;
  top += met != 0;
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
