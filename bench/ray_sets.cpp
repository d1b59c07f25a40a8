// SPDX-License-Identifier: Apache-2.0
#include "bench/ray_sets.h"

#include "core/checked_ray.h"
#include "integrators/path.h"
#include "integrators/render.h"

namespace twinray::bench {
namespace {

/// Hands every query on to another accelerator and writes the ray down. For one thread only.
class Recorder final : public Accelerator {
 public:
  Recorder(std::unique_ptr<Accelerator> engine, const Vec3& eye) : engine_(std::move(engine)), eye_(eye) {}

  Aabb bounds() const noexcept override { return engine_->bounds(); }
  AccelStats stats() const override { return engine_->stats(); }
  std::vector<RecordedRay> take() { return std::move(recorded_); }

 private:
  /// A checked ray as its caller gave it; path tracing never leaves the range in which directions are not
  /// scaled.
  static Ray original(const CheckedRay& ray) {
    return {.origin = ray.origin, .direction = ray.direction, .t_min = ray.t_min, .t_max = ray.t_max};
  }
  Hit trace_closest(const CheckedRay& ray) const noexcept override {
    recorded_.push_back({original(ray), ray.origin == eye_ ? RayKind::camera : RayKind::bounce});
    return engine_->closest_hit(recorded_.back().ray);
  }
  bool trace_any(const CheckedRay& ray) const noexcept override {
    recorded_.push_back({original(ray), RayKind::shadow});
    return engine_->any_hit(recorded_.back().ray);
  }
  Hit count_closest(const CheckedRay& ray, QueryCounts&) const noexcept override {
    return trace_closest(ray);
  }
  bool count_any(const CheckedRay& ray, QueryCounts&) const noexcept override { return trace_any(ray); }

  std::unique_ptr<Accelerator> engine_;
  Vec3 eye_;
  mutable std::vector<RecordedRay> recorded_;
};

}  // namespace

std::vector<RecordedRay> record_rays(const Scene& scene, const Recording& recording) {
  Recorder recorder(build_accelerator(Backend::bvh, scene.geometry), scene.camera.position);
  const PathIntegrator path(scene, {.max_depth = recording.max_depth});
  render(scene, recorder, path,
         {.width = recording.width, .height = recording.height, .samples = recording.samples, .threads = 1});
  return recorder.take();
}

std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind) {
  std::vector<Ray> rays;
  for (const RecordedRay& entry : recorded)
    if (entry.kind == kind) rays.push_back(entry.ray);
  return rays;
}

}  // namespace twinray::bench
