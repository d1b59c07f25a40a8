// SPDX-License-Identifier: Apache-2.0
// What all benchmarks share: the scenes, their recorded rays, the engines, and the check that comes before
// the clock.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "core/scene.h"
#include "integrators/recorded_rays.h"

namespace twinray::bench {

/// An engine as benchmarks name it: a backend with its options.
struct Engine {
  std::string name;
  Backend backend = Backend::bvh;
  BuildOptions options;
};

/// Every backend of this build and every split method; brute force last.
std::vector<Engine> engines();

/// A scene, loaded when first asked for and kept; seen as a whole (view_whole), in 4 : 3.
class Workload {
 public:
  Workload(std::string name, std::string path) : name_(std::move(name)), path_(std::move(path)) {}

  const std::string& name() const { return name_; }
  const Scene& scene();
  const std::vector<RecordedRay>& recorded();
  std::vector<Ray> rays(RayKind kind) { return rays_of_kind(recorded(), kind); }
  std::unique_ptr<Accelerator> build(const Engine& engine);

  /// Compares the engine's answers with brute force on some rays and with the BVH on all; empty if it may be
  /// timed, else what is wrong. Engines with the canonical hit must have the same bits; embree-native may
  /// miss or differ on one ray of a thousand.
  std::string check(const Engine& engine, const Accelerator& accelerator);

 private:
  std::string name_, path_;
  std::unique_ptr<Scene> scene_;
  std::vector<RecordedRay> recorded_;
  std::vector<Hit>
      expected_;  ///< The BVH's answers, proved on a sample by brute force; t = 0 stands for occluded.
};

/// Our own box with a mesh and with spheres, and where `folder` holds them cow, CBbunny, CBlucy and CBdragon.
std::vector<std::shared_ptr<Workload>> workloads(const std::string& own_scenes, const std::string& folder);

/// Each registers its benchmarks for all workloads and engines.
void register_trace(const std::vector<std::shared_ptr<Workload>>& workloads);
void register_build(const std::vector<std::shared_ptr<Workload>>& workloads);
void register_render(const std::vector<std::shared_ptr<Workload>>& workloads);

}  // namespace twinray::bench
