// SPDX-License-Identifier: Apache-2.0
#include "bench/ray_sets.h"

#include "integrators/path.h"

namespace twinray::bench {
namespace {

/// The middle of a pixel where it has one sample, else a point of it.
Vec2 point_in_pixel(const Recording& recording, const SampleKey& key) {
  if (recording.samples == 1) return {0.5f, 0.5f};
  return VertexSampler(SamplerKind::independent, key, 0).draw_2d(Purpose::pixel);
}

}  // namespace

std::vector<RecordedRay> record_rays(const Scene& scene, const Recording& recording) {
  const auto accelerator = build_accelerator(Backend::bvh, scene.geometry);
  const PathIntegrator path(scene, {.max_depth = recording.max_depth});
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

std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind) {
  std::vector<Ray> rays;
  for (const RecordedRay& entry : recorded)
    if (entry.kind == kind) rays.push_back(entry.ray);
  return rays;
}

}  // namespace twinray::bench
