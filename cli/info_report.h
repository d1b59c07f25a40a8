// SPDX-License-Identifier: Apache-2.0
// What is in a scene, as text and as JSON.
#pragma once
#include <string>

#include "cli/scene_info.h"

namespace twinray {

/// Lines of text; of many materials and pictures those that make the most of the scene.
std::string info_text(const SceneInfo& info);

/// Everything, as a JSON object.
std::string info_json(const SceneInfo& info);

}  // namespace twinray
