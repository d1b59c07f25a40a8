// SPDX-License-Identifier: Apache-2.0
// A scene with the rays of its own paths, recorded once, and the check that comes before the clock.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/engines.h"
#include "check/recorded_rays.h"
#include "core/scene.h"

namespace twinray::bench {

/// Rays of one kind that start at one vertex of their paths.
struct RaySetKind {
  const char* name;   ///< One word.
  const char* title;  ///< For people.
  RayKind kind;
  int vertex;
};

/// The sets, in the order of all tables.
inline constexpr std::array<RaySetKind, 5> ray_sets{{{"camera", "camera", RayKind::camera, 0},
                                                     {"shadow-1", "shadow", RayKind::shadow, 1},
                                                     {"bounce-1", "1st bounce", RayKind::bounce, 1},
                                                     {"shadow-2", "2nd shadow", RayKind::shadow, 2},
                                                     {"bounce-2", "2nd bounce", RayKind::bounce, 2}}};

/// A scene that can be measured, and how to come by it.
struct SceneSource {
  std::string name;
  std::string family;  ///< The maker of a generated scene, for growth; else empty.
  std::function<Scene()> make;
  std::string file = {};  ///< Empty for a generated scene.
};

/// The first ray, and each `step` behind.
std::vector<Ray> every(std::size_t step, const std::vector<Ray>& rays);

class Workload {
 public:
  /// Makes the scene and records the rays of a picture of that size, one sample a pixel.
  Workload(const SceneSource& source, int width, int height);

  const SceneSource& source() const { return source_; }
  const Scene& scene() const { return scene_; }
  std::size_t primitives() const { return scene_.geometry->primitive_count(); }
  /// Of ray_sets[set], in the picture's order.
  const std::vector<Ray>& rays(std::size_t set) const { return rays_[set]; }
  std::unique_ptr<Accelerator> build(const Engine& engine, int threads) const;

  /// Compares the answers that the engine gives in its own way with those of the binary BVH, which brute
  /// force has proved on some rays. Empty if the engine may be timed, else what is wrong. Engines with the
  /// canonical hit must have the same bits; Embree's own triangles may miss, or differ, on one ray of a
  /// thousand.
  std::string check(const Engine& engine, const Accelerator& accelerator);

 private:
  void expect();

  SceneSource source_;
  Scene scene_;
  std::array<std::vector<Ray>, ray_sets.size()> rays_;
  std::array<std::vector<Hit>, ray_sets.size()>
      expected_;  ///< t = 0 stands for a shadow ray that is blocked.
  std::string oracle_complaint_;
  bool is_expected_ = false;
};

}  // namespace twinray::bench
