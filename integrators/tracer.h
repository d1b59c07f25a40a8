// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "accel/accelerator.h"
#include "core/rgb.h"

namespace twinray {

/// Rays traced, by kind, and what they did in the accelerator where that was asked for.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;  ///< Connections to lights.
  std::uint64_t bounce = 0;  ///< Scattered directions, those of hemisphere sampling included.
  QueryCounts queries;       ///< Zero unless counted.

  std::uint64_t total() const { return camera + shadow + bounce; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    bounce += other.bounce;
    queries += other.queries;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

enum class RayKind { camera, shadow, bounce };

struct RecordedRay {
  Ray ray;
  RayKind kind = RayKind::camera;
  int vertex = 0;  ///< The path's vertex where it starts: 0 the camera, 1 the first surface, ...
};

/// An integrator's only way to rays: asks an accelerator and keeps the counts of one thread's work.
class Tracer {
 public:
  /// With `counting`, each query goes through the slower counting traversal. Where `record` is given, each
  /// ray is appended to it; it must outlive the tracer.
  Tracer(const Accelerator& accelerator, bool counting, std::vector<RecordedRay>* record = nullptr)
      : accelerator_(accelerator), counting_(counting), record_(record) {}

  /// A new path begins.
  Hit camera_hit(const Ray& ray) {
    vertex_ = 0;
    ++counts_.camera;
    note(ray, RayKind::camera);
    return closest(ray);
  }
  Hit bounce_hit(const Ray& ray) {
    ++counts_.bounce;
    note(ray, RayKind::bounce);
    return closest(ray);
  }
  /// How much of the light passes along a connection (core/offset.h), per channel: white where nothing is in
  /// the way.
  Rgb visibility(const Ray& connection) {
    ++counts_.shadow;
    note(connection, RayKind::shadow);
    const bool blocked =
        counting_ ? accelerator_.any_hit(connection, counts_.queries) : accelerator_.any_hit(connection);
    return blocked ? Rgb{} : Rgb{1, 1, 1};
  }
  /// The path has come to its next surface: rays start there from now on.
  void arrive() { ++vertex_; }
  const RayCounts& counts() const { return counts_; }

 private:
  void note(const Ray& ray, RayKind kind) {
    if (record_) record_->push_back({ray, kind, vertex_});
  }
  Hit closest(const Ray& ray) {
    return counting_ ? accelerator_.closest_hit(ray, counts_.queries) : accelerator_.closest_hit(ray);
  }

  const Accelerator& accelerator_;
  bool counting_;
  std::vector<RecordedRay>* record_;
  int vertex_ = 0;
  RayCounts counts_;
};

}  // namespace twinray
