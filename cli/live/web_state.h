// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "cli/live/live_layers.h"
#include "integrators/render.h"

namespace twinray {

/// What pages know of a render besides its pixels.
struct WebState {
  std::string picture,
      partial;  ///< The files; `partial` of a render that is stopped, empty where none is kept.
  enum class Phase { loading, rendering, ended } phase = Phase::loading;
  bool is_complete = false;             ///< Of one that has ended: it was not stopped.
  bool is_stopping = false;             ///< Somebody asked for its end.
  int width = 0, height = 0;            ///< 0 while it is loading.
  std::vector<LiveLayer> layers;        ///< The colours first.
  std::vector<std::uint64_t> versions;  ///< Of each layer; 0: there is no copy yet.
  RenderProgress progress;
  double seconds = 0;  ///< Of rendering.
};

/// As the page reads it (docs/viewer.md).
std::string state_json(const WebState& state);

}  // namespace twinray
