// SPDX-License-Identifier: Apache-2.0
#include "check/recorded_rays.h"

#include "core/camera.h"
#include "core/random.h"

namespace twinray {
namespace {

/// The middle of a pixel where it has one sample, else a point of it.
Vec2 point_in_pixel(const Recording& recording, const SampleKey& key) {
  if (recording.samples == 1) return {0.5f, 0.5f};
  return VertexSampler(SamplerKind::independent, PathKey(key), 0).draw_2d(Purpose::pixel);
}

}  // namespace

void record_sample(const Integrator& integrator, const Camera& camera, const Accelerator& accelerator,
                   Vec2 frame, const SampleKey& key, std::vector<RecordedRay>& rays) {
  Tracer tracer(accelerator, false, &rays);
  const VertexSampler sampler(SamplerKind::independent, PathKey(key), 0);
  const Vec2 lens = has_lens(camera) ? sampler.draw_2d(Purpose::lens) : Vec2{};
  integrator.radiance(lens_ray(camera, frame, lens).ray, SamplerKind::independent, key, tracer);
}

std::vector<RecordedRay> record_rays(const Scene& scene, const Recording& recording) {
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = recording.max_depth, .direct = DirectMethod::lights});
  const Camera camera = fit_frame(scene.camera, recording.width, recording.height);
  std::vector<RecordedRay> rays;
  for (int y = 0; y < recording.height; ++y)
    for (int x = 0; x < recording.width; ++x)
      for (std::uint32_t index = 0; index < recording.samples; ++index) {
        const SampleKey key{0, std::uint32_t(x), std::uint32_t(y), index};
        const Vec2 in_pixel = point_in_pixel(recording, key);
        const Vec2 frame{(float(x) + in_pixel.x) / float(recording.width),
                         (float(y) + in_pixel.y) / float(recording.height)};
        record_sample(path, camera, *accelerator, frame, key, rays);
      }
  return rays;
}

RayClass class_of(RayKind kind) {
  switch (kind) {
    case RayKind::camera:
      return RayClass::camera;
    case RayKind::shadow:
      return RayClass::shadow;
    default:
      return RayClass::bounce;
  }
}

std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind) {
  std::vector<Ray> rays;
  for (const RecordedRay& entry : recorded)
    if (entry.kind == kind) rays.push_back(entry.ray);
  return rays;
}

std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind, int vertex) {
  std::vector<Ray> rays;
  for (const RecordedRay& entry : recorded)
    if (entry.kind == kind && entry.vertex == vertex) rays.push_back(entry.ray);
  return rays;
}

PathRays::PathRays(const Scene& scene, const Accelerator& accelerator, std::uint64_t seed)
    : accelerator_(accelerator),
      seed_(seed),
      path_(scene, {}),
      cameras_{fit_frame(scene.camera, 4, 3),
               view_whole(fit_frame(scene.camera, 4, 3), accelerator.bounds())} {}

std::vector<RecordedRay> PathRays::batch(std::uint64_t batch, std::size_t count) const {
  std::vector<RecordedRay> rays;
  Random random(seed_, batch);
  for (std::uint32_t path = 0; rays.size() < count; ++path) {
    const float x = random.unit();
    const float y = random.unit();
    const SampleKey key{random.bits(), std::uint32_t(batch), std::uint32_t(batch >> 32), path};
    record_sample(path_, cameras_[path % 2], accelerator_, {x, y}, key, rays);
  }
  rays.resize(count);
  return rays;
}

}  // namespace twinray
