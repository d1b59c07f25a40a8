// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace twinray {

/// How a binary BVH divides the primitives of a node.
enum class BvhSplit {
  sah,       ///< The cheapest of the binned candidates on three axes, or none (Wald 2007).
  median,    ///< Half of the primitives each, by centroid along the longest axis.
  midpoint,  ///< The middle of the centroids' box on its longest axis.
  mean,      ///< The mean of the centroids on that axis.
};

/// Who makes the binary tree of the bvh engine.
enum class BvhBuilder {
  own,            ///< Our builder, by bvh_split.
  embree_low,     ///< Embree's, quality LOW: along a curve of Morton codes.
  embree_medium,  ///< Embree's, quality MEDIUM: binned SAH.
  embree_high,  ///< Embree's, quality HIGH: the same with spatial splits; a primitive may lie in many leaves.
};

/// How much memory a bvh of width 8 takes, in bytes a triangle: the tree alone, and while it is built.
enum class MemoryMode {
  ordinary,  ///< About 65, and 140.
  compact,   ///< 25 to 32, and of more than a million 40 to 85; rays take 1.2 to 2.4 times as long.
};

/// How much time goes into the tree of a bvh of width 8.
enum class BvhQuality {
  fast,    ///< Half of the bins, and the hundredth of all nodes with the largest areas are reinserted.
  medium,  ///< A twentieth of all nodes is reinserted.
  high,    ///< All nodes are.
};

enum class EmbreeMode { robust, fast };

/// How well Embree builds the trees of embree_native, by its own names. Robust mode makes of `high` what it
/// makes of `medium`.
enum class EmbreeQuality {
  medium,  ///< Binned SAH: Embree's default.
  high,    ///< SAH with spatial splits.
};

/// Which ray-triangle test the bvh engine runs.
enum class TriangleTest { woop, moller_trumbore };

/// How an accelerator is built. Each backend reads what concerns it.
struct BuildOptions {
  int threads = 0;  ///< 0: as many as the process may use. The tree does not depend on it.

  /// bvh only: children of a node, 2 or 8. 8: the fast tree; 2: the readable one, whose counts compare.
  int bvh_width = 8;
  /// bvh of width 8 and the leaves of embree: their instruction set, one of available_instruction_sets().
  std::string simd = "best";
  BvhSplit bvh_split = BvhSplit::sah;
  int bvh_bins = 32;                              ///< 2 to 256.
  BvhBuilder bvh_builder = BvhBuilder::own;       ///< bvh only; split and bins apply to `own` alone.
  BvhQuality bvh_quality = BvhQuality::medium;    ///< bvh of width 8 only.
  MemoryMode memory_mode = MemoryMode::ordinary;  ///< bvh of width 8 only.
  int max_leaf_size = 4;  ///< 1 to 255 primitives; to 32 by Embree's builders; above 4, 4 with a width of 8.
  /// The SAH cost counts primitives rounded up to a multiple of this, 1 to 255; bvh_builder `own` alone. A
  /// width of 8 takes 4 instead.
  int leaf_block = 1;
  double traversal_cost = 1.0;     ///< SAH cost of a node step, > 0.
  double intersection_cost = 1.0;  ///< SAH cost of a primitive test, > 0.
  /// bvh only. moller_trumbore: the binary tree with another test, to compare with; outside of the promise of
  /// equal bits.
  TriangleTest triangle_test = TriangleTest::woop;

  EmbreeMode embree_mode = EmbreeMode::robust;           ///< embree_native only.
  EmbreeQuality embree_quality = EmbreeQuality::medium;  ///< embree_native only.
  /// embree and embree_native: the most that Embree may use: sse2, sse4.2, avx, avx2, avx512; or default:
  /// what it chooses itself. Its traversal of user geometry was 3 % faster with AVX2 than with AVX-512.
  std::string embree_isa = "avx2";
};

}  // namespace twinray
