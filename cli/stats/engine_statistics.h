// SPDX-License-Identifier: Apache-2.0
// One scene's rays through every engine: what building took, what a ray takes.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "check/recorded_rays.h"
#include "cli/crosscheck/agreement.h"
#include "core/scene.h"

namespace twinray {

/// The kinds of rays, in the order of all tables.
inline constexpr std::array<RayKind, 3> ray_kinds{RayKind::camera, RayKind::shadow, RayKind::bounce};
/// "camera", "shadow", "bounce".
std::string ray_kind_name(RayKind kind);

/// Every split method and builder of the hand-written BVH, and the other engines of this build; brute force
/// comes last.
std::vector<AgreementEngine> stats_engines();

struct StatsOptions {
  Recording recording;
  int threads = 0;             ///< For building and for the rays; 0: as many as the process may use.
  double least_seconds = 0.1;  ///< The rays of a kind are shot until this has passed, at least once.
  /// Primitive tests that one pass of brute force may make; beyond, it is left out.
  double brute_force_tests = 5e7;
};

/// What the rays of one kind did in an engine.
struct RayStatistics {
  std::size_t rays = 0;
  QueryCounts counts;          ///< Of all of them; the same on every machine.
  double rays_per_second = 0;  ///< Of the fastest pass, without counting; 0 without rays.
};

struct EngineStatistics {
  std::string name;
  AccelStats build;
  bool has_tree = false;              ///< Whether nodes, depth, SAH cost and the nodes of rays are known.
  bool has_primitives = false;        ///< Whether the primitives of rays are known.
  std::array<RayStatistics, 3> rays;  ///< By ray_kinds.
};

struct SceneStatistics {
  std::vector<EngineStatistics> engines;
  bool is_brute_force_left_out = false;
};

/// Records the rays of one picture once, builds each engine, and shoots them. Engines that promise the same
/// bits must give the first one's answers; an Error names the first ray that is answered otherwise.
/// `progress`, if set, is told what is being done.
SceneStatistics measure_engines(const Scene& scene, const StatsOptions& options,
                                const std::function<void(const std::string&)>& progress = {});

}  // namespace twinray
