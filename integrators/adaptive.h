// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/film.h"

namespace twinray {

/// When a pixel has enough samples: with n so far, m the mean and s^2 the variance of their luminance.
///
/// A pixel that stops early has missed light that is rare in it, and no later sample makes up for that: every
/// such rule darkens where few samples bring much light. `careful` takes little for granted: its interval is
/// that of 3.5 standard errors, as if one more sample, 2 m brighter than the mean, had been among them; and a
/// pixel that is black so far goes on, unless nothing of the scene can be seen through it. docs/adaptive.md
/// has what either rule loses on well-known scenes.
enum class AdaptiveRule {
  careful,  ///< 3.5 sqrt((s^2 + (2 m)^2 / n) / n) <= tolerance m, and m > 0.
  cs184,    ///< 1.96 s / sqrt(n) <= tolerance m, as the course's program has it: black pixels stop at once.
};

/// Stops sampling a pixel once it is known well enough: asked every `batch` samples.
struct AdaptiveSampling {
  std::uint32_t batch = 32;  ///< >= 1. A pixel needs two samples to stop in any case.
  double tolerance = 0.05;   ///< >= 0.
  AdaptiveRule rule = AdaptiveRule::careful;
};

/// Whether the pixel's samples so far are enough. A function of its sums alone.
bool has_enough_samples(const PixelSums& pixel, const AdaptiveSampling& adaptive);

}  // namespace twinray
