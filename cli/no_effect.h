// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/options/render.h"
#include "core/scene.h"
#include "io/scene_summary.h"

namespace twinray {

/// Each given option that changes nothing beside the other options, and why: "--bvh-split: no effect, for the
/// engine is embree; --accel=bvh takes it".
std::vector<std::string> options_without_effect(const RenderRequest& request,
                                                const RenderArguments& arguments);

/// The same for given options that change nothing in this scene; the lights that it is given beside its own
/// count as well.
std::vector<std::string> options_without_effect(const Scene& scene, const RenderArguments& arguments,
                                                const std::vector<Light>& added = {});
/// The same of what its file says of it.
std::vector<std::string> options_without_effect(const SceneSummary& summary,
                                                const RenderArguments& arguments);

}  // namespace twinray
