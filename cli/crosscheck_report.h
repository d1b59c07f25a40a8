// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>

#include "check/ceilings.h"
#include "check/scene_crosscheck.h"
#include "io/scene_file.h"

namespace twinray {

/// The command that shoots rays of a scene again, up to the options that name the ray.
std::string replay_command(const std::string& scene, const LoadOptions& load);

/// How a ray is called: "camera 1234", by its class and its number in it.
std::string ray_label(const Finding& finding);

/// A table for each engine but the reference, of classes of differences by classes of rays, and below it what
/// is wrong, each ray with its label and the command that shoots it again.
std::string crosscheck_text(const SceneCrosscheck& result, const std::string& replay,
                            const std::function<std::string(const Finding&)>& label = ray_label);

/// The same for machines; with all findings.
std::string crosscheck_json(const SceneCrosscheck& result, const std::string& scene,
                            const std::string& replay);

/// What each engine and the oracle say about one ray.
std::string ray_crosscheck_text(const RayCrosscheck& result);

/// Whether nothing is unexplained and no ceiling is passed.
bool is_passed(const CrosscheckReport& report);

}  // namespace twinray
