// SPDX-License-Identifier: Apache-2.0
#include "check/visible_emitters.h"

#include "core/surface.h"

namespace twinray {
namespace {

/// White where the first hit emits, else black.
class EmitterIntegrator final : public PlainIntegrator {
 public:
  explicit EmitterIntegrator(const Scene& scene) : scene_(scene) {}

 private:
  Rgb radiance_of(const CameraSample& sample, SamplerKind, Tracer& tracer) const override {
    const Hit hit = tracer.camera_hit(sample.ray);
    if (hit.is_miss()) return {};
    const std::uint32_t shape = surface_at(*scene_.geometry, hit).shape;
    return scene_.bindings[shape].light == no_light ? Rgb{} : Rgb{1, 1, 1};
  }

  const Scene& scene_;
};

}  // namespace

PixelMask pixels_without_emitters(const Scene& scene, const Accelerator& accelerator,
                                  const RenderOptions& options, std::uint32_t rays_a_pixel) {
  RenderOptions first_hits = options;
  first_hits.samples = rays_a_pixel;
  first_hits.adaptive.reset();
  const RenderResult result = render(scene, accelerator, EmitterIntegrator(scene), first_hits);
  PixelMask mask;
  for (const Rgb& seen : mean_image(result.film).pixels) mask.push_back(is_black(seen));
  return mask;
}

}  // namespace twinray
