// SPDX-License-Identifier: Apache-2.0
// Private: how a traversal comes to the block of a leaf, compiled once for each instruction set.
#if defined(TWINRAY_ACCEL_WIDE_OPEN_LEAVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_ACCEL_WIDE_OPEN_LEAVES_INL_H
#undef TWINRAY_ACCEL_WIDE_OPEN_LEAVES_INL_H
#else
#define TWINRAY_ACCEL_WIDE_OPEN_LEAVES_INL_H
#endif

#include <cstddef>

#include "accel/canonical/nearest.h"
#include "accel/wide/node.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Prefetches what will be visited: `bytes` from its first cache line on.
template <std::size_t bytes>
HWY_ATTR HWY_INLINE void prefetch_bytes(const void* first) {
  constexpr std::size_t line = 64;
  for (std::size_t i = 0; i < bytes; i += line) __builtin_prefetch(static_cast<const char*>(first) + i);
}
template <typename T>
HWY_ATTR HWY_INLINE void prefetch(const T& visited) {
  prefetch_bytes<sizeof(T)>(&visited);
}

/// The leaves that a query holds. A tree of another kind has a specialisation that makes its blocks here.
template <typename Tree>
class OpenLeaves {
 public:
  /// Valid until the next call of open().
  HWY_ATTR HWY_INLINE const PrimitiveBlock& open(const Tree& bvh, WideRef leaf) { return bvh.block(leaf); }
  /// The block that `best` names stays valid until it names another.
  void keep(const Nearest&) {}
  static HWY_ATTR HWY_INLINE void prefetch(const Tree& bvh, WideRef leaf) {
    HWY_NAMESPACE::prefetch(bvh.block(leaf));
  }
};

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
