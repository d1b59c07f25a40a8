// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "accel/accelerator.h"
#include "core/rgb.h"
#include "integrators/path_observer.h"

namespace twinray {

/// Rays traced, by kind, and what they did in the accelerator where that was asked for.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;  ///< Towards lights.
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

/// An integrator's only way to rays: asks an accelerator and keeps the counts of one thread's work. Who
/// watches a path (integrators/path_observer.h) is found here, too.
class Tracer {
 public:
  /// With `counting`, each query goes through the slower counting traversal. Where `record` is given, each
  /// ray is appended to it; it must outlive the tracer.
  Tracer(const Accelerator& accelerator, bool counting, std::vector<RecordedRay>* record = nullptr)
      : accelerator_(accelerator), counting_(counting), record_(record) {}
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  /// A new path begins.
  Hit camera_hit(const Ray& ray) {
    vertex_ = 0;
    note({&ray, 1}, RayKind::camera, counts_.camera);
    return closest(ray);
  }
  Hit bounce_hit(const Ray& ray) {
    note({&ray, 1}, RayKind::bounce, counts_.bounce);
    return closest(ray);
  }

  /// Of a ray that goes on where another one of this kind has been.
  Hit hit(const Ray& ray, RayKind kind) {
    note({&ray, 1}, kind, kind == RayKind::shadow ? counts_.shadow : counts_.bounce);
    return closest(ray);
  }

  /// The same for several paths that grow vertex by vertex together: hits[i] is that of rays[i].
  void camera_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    vertex_ = 0;
    note(rays, RayKind::camera, counts_.camera);
    closest(rays, hits);
  }
  void bounce_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    this->hits(rays, RayKind::bounce, hits);
  }
  /// Of rays that go on where others of this kind have been, or begin as they do.
  void hits(std::span<const Ray> rays, RayKind kind, std::span<Hit> hits) {
    note(rays, kind, kind == RayKind::shadow ? counts_.shadow : counts_.bounce);
    closest(rays, hits);
  }
  /// The visibility along a shadow ray, likewise.
  Rgb visibility(const Ray& shadow_ray) {
    note({&shadow_ray, 1}, RayKind::shadow, counts_.shadow);
    return is_blocked(shadow_ray) ? Rgb{} : Rgb{1, 1, 1};
  }
  /// The visibility along each shadow ray (core/spawn_ray.h), per channel: white where nothing blocks it.
  /// Valid until the next call.
  std::span<const Rgb> visibilities(std::span<const Ray> shadow_rays);

  /// The paths have come to their next surfaces: rays start there from now on.
  void arrive() { ++vertex_; }
  const RayCounts& counts() const { return counts_; }

  /// From now on PathReference tells the observer, which must outlive the tracer, what it does.
  void watch(PathObserver& observer) { observer_ = &observer; }
  PathObserver& observer() const { return *observer_; }

 private:
  void note(std::span<const Ray> rays, RayKind kind, std::uint64_t& count) {
    count += rays.size();
    if (record_)
      for (const Ray& ray : rays) record_->push_back({ray, kind, vertex_});
  }
  Hit closest(const Ray& ray) {
    return accelerator_.closest_hit({ray, counting_ ? &counts_.queries : nullptr});
  }
  bool is_blocked(const Ray& shadow_ray) {
    return accelerator_.any_hit({shadow_ray, counting_ ? &counts_.queries : nullptr});
  }
  void closest(std::span<const Ray> rays, std::span<Hit> hits);

  const Accelerator& accelerator_;
  bool counting_;
  std::vector<RecordedRay>* record_;
  int vertex_ = 0;
  RayCounts counts_;
  PathObserver nobody_;
  PathObserver* observer_ = &nobody_;
  std::vector<std::uint8_t> blocked_;
  std::vector<Rgb> visible_;
};

}  // namespace twinray
