// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <optional>
#include <string>

#include "integrators/render.h"
#include "io/progress_line.h"

namespace twinray {

/// The line on standard error; with `enabled` false nothing is shown.
ProgressLine progress_line(bool enabled);

// The seconds below are those for which this process has been sampling.

/// How much is done, from 0 to 1, by each of what may end a render.
struct ProgressShares {
  double of_samples = 0, of_time = 0, of_noise = 0;
  double most() const { return std::min(1.0, std::max({of_samples, of_time, of_noise})); }
};
ProgressShares progress_shares(const RenderProgress& progress, double elapsed_seconds);

/// How long it goes on if it goes on like this; nothing where only its samples tell, before 1 % is done.
std::optional<double> seconds_left(const RenderProgress& progress, double elapsed_seconds);
/// The mean until now, over all processes; 0 at the beginning.
double rays_per_second(const RenderProgress& progress, double elapsed_seconds);

/// "42 % | 1.2 of 2.9 M samples | 3.1 M rays/s | 12 s, 17 s left"; of samples, of time or of a noise target,
/// whichever ends first, and without the number of samples that will not be made. With a target
/// "error 0.05, target 0.01 | " stands before the rays.
std::string progress_text(const RenderProgress& progress, double elapsed_seconds);

}  // namespace twinray
