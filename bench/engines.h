// SPDX-License-Identifier: Apache-2.0
// The engines that are measured, in one table.
#pragma once
#include <string>
#include <vector>

#include "accel/accelerator.h"

namespace twinray::bench {

/// When an engine takes part.
enum class Wanted {
  always,
  full,   ///< Only where everything is asked for.
  small,  ///< Only on scenes of up to small_scene primitives.
};

/// How an engine is handed its rays.
enum class Asked {
  singly,
  in_batches,  ///< Through closest_hits() and any_hits().
  directly,    ///< By Embree's own functions, without our interface; embree_native only.
};

inline constexpr std::size_t small_scene = 150'000;

/// A backend with its options, as benchmarks name it.
struct Engine {
  std::string name;
  Backend backend = Backend::bvh;
  BuildOptions options;
  Wanted wanted = Wanted::always;
  std::string what;  ///< In a few words, for people.
  Asked asked = Asked::singly;

  /// Whether it promises the canonical answers, bit for bit.
  bool is_canonical() const { return backend != Backend::embree_native; }
};

/// All engines of this build. The first is the baseline of every ratio: Embree called directly, with its own
/// triangles, robust, as it comes; without Embree, our default BVH.
std::vector<Engine> engines();

}  // namespace twinray::bench
