// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/scene.h"
#include "io/diagnostic.h"
#include "io/render_defaults.h"
#include "io/scene_summary.h"

namespace twinray {

/// What a reader makes of a scene file.
struct LoadedScene {
  Scene scene;  ///< Checked by check_scene().
  std::vector<Diagnostic> warnings;
  SceneSummary summary;
  RenderDefaults defaults;
  bool wants_light = false;  ///< It has no light, as most files of its format: it is to be lit by default.
};

}  // namespace twinray
