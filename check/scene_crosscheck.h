// SPDX-License-Identifier: Apache-2.0
// The crosscheck of a whole scene: all classes of rays through all engines.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "accel/engines.h"
#include "check/crosscheck.h"
#include "core/scene.h"

namespace twinray {

struct CrosscheckOptions {
  /// By their names (accel/engines.h), in any order; at least two, bvh, bvh-2 or embree among them.
  std::vector<std::string> engines;
  BuildOptions build;
  std::uint64_t rays = 1000000;  ///< Of all classes together; brute force takes 10^4 of them at most.
  std::uint64_t seed = 0;
  int threads = 0;        ///< 0: as many as the process may use.
  std::size_t kept = 10;  ///< Findings of each engine and class that are kept.
};

struct SceneCrosscheck {
  std::vector<std::string> engines;  ///< In the order of the report, the reference first.
  CrosscheckReport report;
  double seconds = 0;  ///< Building included.
};

/// Whether others can be held to the engine: it has the promised bits, and can be asked for every ray.
bool can_be_reference(const Engine& engine);

/// The engines that are checked where none are named: all of this build but brute force, which takes part
/// only where there is no Embree. bvh is the first.
std::vector<std::string> default_crosscheck_engines();

/// Traces the rays. The report depends on scene, engines, rays and seed alone, and memory on the scene alone.
/// `progress`, if set, is called with the rays done so far, from one thread at a time. Throws Error for
/// options out of range.
SceneCrosscheck crosscheck_scene(const Scene& scene, const CrosscheckOptions& options,
                                 const std::function<void(std::uint64_t)>& progress = {});

/// One ray through all engines and brute force, at one placement of the scene.
struct RayCrosscheck {
  struct Row {
    std::string engine;
    Answer answer;
    Difference difference;  ///< From the reference, the first row.
  };
  std::vector<Row> rows;
  std::vector<JudgedHit> truth;  ///< All primitives that the exact ray hits, by t (check/judge.h).
};

RayCrosscheck crosscheck_ray(const Scene& scene, const Ray& ray, Placement placement,
                             const CrosscheckOptions& options);

}  // namespace twinray
