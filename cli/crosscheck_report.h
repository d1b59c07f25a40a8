// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "accel/crosscheck/ceilings.h"
#include "integrators/scene_crosscheck.h"

namespace twinray {

/// A table for each engine but the reference, of classes of differences by classes of rays, and below it what
/// is wrong, each ray as the command that shoots it again.
std::string crosscheck_text(const SceneCrosscheck& result, const std::string& scene);

/// The same for machines; with all findings.
std::string crosscheck_json(const SceneCrosscheck& result, const std::string& scene);

/// What each engine and the oracle say about one ray.
std::string ray_crosscheck_text(const RayCrosscheck& result);

/// Whether nothing is unexplained and no ceiling is passed.
bool is_passed(const CrosscheckReport& report);

}  // namespace twinray
