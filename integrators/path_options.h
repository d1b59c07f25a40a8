// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/rgb.h"
#include "integrators/bounce_limits.h"
#include "integrators/direct_light.h"

namespace twinray {

/// When a path is given up at random (and its weight raised, so that the mean stays).
struct Roulette {
  /// A fixed probability of going on, in (0, 1], from the second bounce on. 0: the square root of the path's
  /// largest throughput component, up to 1, from the fourth bounce on. By the throughput itself too few paths
  /// go on, and each weighs too much: docs/sampling.md has both measured.
  float continuation = 0;

  /// Whether a path may be given up at a bounce (counted from 1). Light of three bounces is much of a room's:
  /// paths that end by their throughput before they bring it cost more noise than they save time.
  bool applies(int bounce) const { return bounce >= (continuation > 0 ? 2 : 4); }
  /// The probability of going on, in [0, 1].
  float probability(const Rgb& throughput) const {
    return continuation > 0 ? continuation : std::min(1.0f, std::sqrt(max_component(throughput)));
  }
};

struct PathOptions {
  int max_depth = 5;  ///< Scattering events: 0 emission only, 1 direct light, ...; 0 to 100.
  /// Only light that was scattered first_depth to last_depth times is added up (within max_depth).
  int first_depth = 0, last_depth = std::numeric_limits<int>::max();
  DirectMethod direct = DirectMethod::mis;
  std::uint32_t samples_per_light = 1;  ///< 1 to 65536.
  BounceLimits limits;                  ///< Besides max_depth.
  Roulette roulette;
  ManyLights many_lights = ManyLights::tree;
  /// Biased, for less noise: no channel of a term of light that was scattered twice or more exceeds this; >
  /// 0.
  float clamp = std::numeric_limits<float>::infinity();
  /// Biased, for less noise: surfaces are rougher to paths that have been scattered widely
  /// (core/regularize.h), so that light samples find what only a mirror's or a lens's ray could.
  bool regularize = false;

  /// The part of a term of light that is added up, which was scattered `depth` times: less than 1 where it is
  /// clamped.
  float clamp_factor(const Rgb& term, int depth) const {
    const float largest = max_component(term);
    return depth >= 2 && largest > clamp ? clamp / largest : 1;
  }
  /// The term as it is added up: its color stays, clamped or not.
  Rgb clamped(const Rgb& term, int depth) const { return term * clamp_factor(term, depth); }
  bool counts(int depth) const { return depth >= first_depth && depth <= last_depth; }
  int depth_limit() const { return std::min(max_depth, last_depth); }
  /// Whether a path is scattered no more after `depth` events, which were of these kinds.
  bool ends(int depth, BounceCounts bounces) const {
    return depth >= depth_limit() || limits.are_reached(bounces);
  }
};

/// Throws Error for options out of range.
void check(const PathOptions& options);

}  // namespace twinray
