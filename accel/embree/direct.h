// SPDX-License-Identifier: Apache-2.0
// Private: Embree's own functions with nothing of ours around them, for benchmarks that compare with Embree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/accelerator.h"

namespace twinray::embree {

/// Which of Embree's functions rays are handed to. Rays are brought into the form that it takes as they go.
enum class Call {
  single,         ///< rtcIntersect1 and rtcOccluded1.
  packets,        ///< rtcIntersect16 and rtcOccluded16.
  stream,         ///< rtcIntersect1M and rtcOccluded1M with rays_a_stream rays.
  packet_stream,  ///< rtcIntersectNM and rtcOccludedNM with as many, in packets of 16.
};
inline constexpr std::size_t rays_a_stream = 1024;

/// What Embree is told: single rays are never coherent.
enum class Rays { incoherent, coherent };

/// How rays are handed to Embree.
struct DirectCall {
  Call call = Call::single;
  Rays rays = Rays::incoherent;
};

/// Whether this Embree has the function: version 4 has no streams.
bool has(Call call);

/// How many rays hit something in the scene of an engine embree_native (throws Error for another one, and for
/// a call that this Embree does not have). `answers`, if not empty, receives each ray's hit. The rays are not
/// checked: each must be valid. Spheres are ours, as is what cuts holes, and their callbacks want a checked
/// ray: geometry with some is asked through the interface, ray by ray; other calls than single throw Error
/// for it.
std::size_t closest_hits_directly(const Accelerator& native, std::span<const Ray> rays, DirectCall how = {},
                                  std::span<Hit> answers = {});
/// The same for any hit; answers are 1 where there is one, else 0.
std::size_t any_hits_directly(const Accelerator& native, std::span<const Ray> rays, DirectCall how = {},
                              std::span<std::uint8_t> answers = {});

}  // namespace twinray::embree
