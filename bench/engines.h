// SPDX-License-Identifier: Apache-2.0
// The engines that are measured.
#pragma once
#include <vector>

#include "accel/engines.h"

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

/// An engine of the table (accel/engines.h), and how it is measured.
struct Engine : twinray::Engine {
  Wanted wanted = Wanted::always;
  Asked asked = Asked::singly;
};

/// All engines of this build. The first is the baseline of every ratio: Embree called directly, with its own
/// triangles, robust, as it comes; without Embree, our default BVH.
std::vector<Engine> engines();

}  // namespace twinray::bench
