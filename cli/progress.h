// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "integrators/render.h"
#include "io/progress_line.h"

namespace twinray {

/// The line on standard error; with `enabled` false nothing is shown.
ProgressLine progress_line(bool enabled);

/// "42 % | 1.2 of 2.9 M samples | 3.1 M rays/s | 12 s, 17 s left"; of samples, of time or of a noise target,
/// whichever ends first, and without the number of samples that will not be made. With a target
/// "error 0.05, target 0.01 | " stands before the rays.
std::string progress_text(const RenderProgress& progress, double elapsed_seconds);

}  // namespace twinray
