// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "cli/render_arguments.h"
#include "integrators/replay.h"

namespace twinray {

/// A sample that was traced again, and all that its numbers refer to.
struct ReplayedSample {
  const RenderArguments& arguments;
  const Scene& scene;
  const Replay& replay;
  std::optional<double> time = {};  ///< In seconds, where something moves: when the sample was made.

  const PixelSample& place() const { return arguments.replay->sample; }
};

}  // namespace twinray
