// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "integrators/scattering.h"

namespace twinray {

/// How often a path has been scattered in each way: a byte for each ScatterKind. No path is scattered more
/// than a hundred times.
using BounceCounts = std::uint32_t;

constexpr BounceCounts one_bounce(ScatterKind kind) { return BounceCounts(1) << 8 * std::uint32_t(kind); }
constexpr int bounces_of(BounceCounts counts, ScatterKind kind) {
  return int(counts >> 8 * std::uint32_t(kind) & 0xff);
}

/// How many indirect bounces of each kind paths make, at most, as Cycles and Arnold count them: by a kind
/// with the limit 0 light is scattered directly from emitters alone. Each in [0, 100].
struct BounceLimits {
  static constexpr int most = 100;  ///< As long as any path: no limit.
  int diffuse = most, glossy = most, transmission = most;

  bool are_any() const { return diffuse < most || glossy < most || transmission < most; }
  /// Whether a path that was scattered so often is scattered no more: its ray only looks for light.
  bool are_reached(BounceCounts counts) const {
    return bounces_of(counts, ScatterKind::diffuse) > diffuse ||
           bounces_of(counts, ScatterKind::glossy) > glossy ||
           bounces_of(counts, ScatterKind::transmission) > transmission;
  }
};

}  // namespace twinray
