// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/render_arguments.h"
#include "core/scene.h"

namespace twinray {

/// What a picture will not show as the scene describes it, by the way it is to be rendered: no light at all,
/// lights that hemisphere sampling cannot find. None for normals and cost.
std::vector<std::string> scene_warnings(const Scene& scene, const RenderArguments& arguments);

}  // namespace twinray
