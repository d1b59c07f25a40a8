// SPDX-License-Identifier: Apache-2.0
// Private: how a node's primitives are divided in two.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include "accel/build/big_vector.h"
#include "accel/build_options.h"
#include "accel/canonical/shape_test.h"
#include "core/aabb.h"
#include "core/lanes.h"

namespace twinray {

/// All that a builder knows of a primitive.
struct BuildPrimitive {
  Aabb box;
  PrimitiveId id;

  Vec3 center() const { return box.center(); }
};

using BuildPrimitives = BigVector<BuildPrimitive>;

/// A node to be: its primitives, their box, and the box of the primitives' centres.
struct NodeRange {
  std::span<BuildPrimitive> primitives;
  Aabb box;
  Aabb centers;

  explicit NodeRange(std::span<BuildPrimitive> primitives);
  /// The axis along which the centres spread most.
  int longest_axis() const;
  /// Whether no plane can part the centres.
  bool is_coincident() const { return centers.lower == centers.upper; }
};

/// Ranges of at least this size are read in parallel.
inline constexpr std::size_t parallel_range = 1 << 16;

/// As two halves: what is written in other parts than it is read in stalls.
inline void swap_in_lanes(BuildPrimitive& a, BuildPrimitive& b) {
  static_assert(sizeof(BuildPrimitive) == 2 * sizeof(Float4));
  Float4 of_a[2], of_b[2];
  std::memcpy(of_a, &a, sizeof a);
  std::memcpy(of_b, &b, sizeof b);
  std::memcpy(static_cast<void*>(&a), of_b, sizeof a);
  std::memcpy(static_cast<void*>(&b), of_a, sizeof b);
}

/// Moves the primitives that are to come first to the front and returns their number. There is no branch on
/// `is_first`, which half of the time would be mispredicted.
template <typename IsFirst>
std::size_t part(std::span<BuildPrimitive> primitives, IsFirst&& is_first) {
  std::size_t count = 0;
  for (BuildPrimitive& primitive : primitives) {
    const bool comes_first = is_first(primitive);
    swap_in_lanes(primitive, primitives[count]);
    count += std::size_t(comes_first);
  }
  return count;
}

// Each function reorders the primitives of a range of two or more, so that those of the first child come
// first, and returns their number: never 0 nor all, but where 0 is said to mean a leaf. The result depends on
// the range alone.

/// The method of the options. 0: a leaf, for the range is no larger than options.max_leaf_size and, with sah,
/// every split would cost more. Coincident centres are halved.
std::size_t divide(const NodeRange& range, const BuildOptions& options);

/// The cheapest candidate on three axes: of a few primitives every way to part them by centre, of more those
/// between bins (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007); 0 where a leaf
/// is allowed and costs no more.
std::size_t divide_by_sah(const NodeRange& range, const BuildOptions& options);
/// The lower half by centre along the longest axis of the centres' box; ids order equal centres.
std::size_t divide_by_median(const NodeRange& range);
/// The middle of the centres' box on its longest axis; the halves of divide_by_median where one side would be
/// empty.
std::size_t divide_by_midpoint(const NodeRange& range);
/// The mean of the centres on that axis; one primitive is moved over where one side would be empty.
std::size_t divide_by_mean(const NodeRange& range);

}  // namespace twinray
