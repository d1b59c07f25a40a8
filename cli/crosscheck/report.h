// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "check/ceilings.h"
#include "check/scene_crosscheck.h"
#include "io/scene_file.h"

namespace twinray {

/// The command that shoots rays of a scene again, up to the options that name the ray.
std::string replay_command(const std::string& scene, const LoadOptions& load,
                           const std::vector<std::string>& engines = default_crosscheck_engines());

/// How a ray is called: "camera 1234", by its class and its number in it.
std::string ray_label(const Finding& finding);

/// What a ceiling that is passed (check/ceilings.h) means. Only Embree's own triangles can pass one, and on
/// meshes with doubled surfaces they do so without any fault.
enum class Ceilings {
  remark,  ///< It is said.
  count,   ///< It is an error, like what is unexplained.
};

/// A table for each engine but the reference, of classes of differences by classes of rays, and below it what
/// is wrong, each ray with its label and the command that shoots it again.
std::string crosscheck_text(const SceneCrosscheck& result, const std::string& replay, Ceilings ceilings,
                            const std::function<std::string(const Finding&)>& label = ray_label);

/// The same for machines; with all findings.
std::string crosscheck_json(const SceneCrosscheck& result, const std::string& scene,
                            const std::string& replay, Ceilings ceilings);

/// What each engine and the oracle say about one ray.
std::string ray_crosscheck_text(const RayCrosscheck& result);

/// Whether nothing is unexplained and, where they count, no ceiling is passed. Whatever canonical engines
/// answer differently is unexplained.
bool is_passed(const CrosscheckReport& report, Ceilings ceilings);

}  // namespace twinray
