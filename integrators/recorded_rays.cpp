// SPDX-License-Identifier: Apache-2.0
#include "integrators/recorded_rays.h"

#include "core/random.h"

namespace twinray {

void record_sample(const Integrator& integrator, const Camera& camera, const Accelerator& accelerator,
                   Vec2 frame, const SampleKey& key, std::vector<RecordedRay>& rays) {
  Tracer tracer(accelerator, false, &rays);
  VertexSampler sampler(SamplerKind::independent, key, 0);
  const Vec2 lens = camera.lens_radius > 0 ? sampler.draw_2d(Purpose::lens) : Vec2{};
  integrator.radiance(camera_ray(camera, frame, lens), SamplerKind::independent, key, tracer);
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
