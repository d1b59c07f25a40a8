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
  // By Embree's own functions, without our interface; embree_native only.
  directly,           ///< Ray by ray.
  in_packets,         ///< 16 rays a call.
  in_streams,         ///< 1024 rays a call.
  in_packet_streams,  ///< 64 packets a call.
};

inline constexpr std::size_t small_scene = 150'000;

/// An engine of the table (accel/engines.h), and how it is measured.
struct Engine : twinray::Engine {
  Wanted wanted = Wanted::always;
  Asked asked = Asked::singly;
  bool is_coherent = false;  ///< What Embree is told of the rays of a packet or stream.

  /// Whether it can be asked about spheres: Embree's packets and streams know none of ours.
  bool takes_spheres() const { return asked <= Asked::directly; }
};

/// All engines of this build. The first is the baseline of every ratio: Embree called directly, with its own
/// triangles, robust, as it comes; without Embree, our default BVH.
std::vector<Engine> engines();

}  // namespace twinray::bench
