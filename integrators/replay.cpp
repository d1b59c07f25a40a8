// SPDX-License-Identifier: Apache-2.0
#include "integrators/replay.h"

#include <bit>
#include <cmath>

#include "core/denormals.h"
#include "integrators/camera_interiors.h"
#include "integrators/path_reference.h"
#include "integrators/wave/camera_stage.h"

namespace twinray {
namespace {

CameraSample camera_sample(const TracedScene& of, const RenderOptions& render, const PixelSample& sample) {
  const Camera camera = fit_frame(of.scene.camera, render.width, render.height);
  const CameraSampling sampling{render.width,   render.height, render.samples,
                                render.sampler, render.seed,   render.filter};
  CameraSample made;
  CameraStage(camera, sampling).make({&sample, 1}, {&made, 1});
  CameraInteriors(of.scene, of.accelerator, camera).find({&made, 1});
  return made;
}

bool same_bits(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

Replay replay(const TracedScene& of, const PathOptions& path, const RenderOptions& render,
              const PixelSample& sample) {
  const KeepDenormals keep;
  Replay made{.sample = camera_sample(of, render, sample)};
  Tracer rendering(of.accelerator, false);
  made.radiance = of.integrator.radiance(made.sample, render.sampler, rendering);
  Tracer watched(of.accelerator, false);
  watched.watch(made.path);
  PathReference(of.scene, path).radiance(made.sample, render.sampler, watched);
  return made;
}

bool same_bits(const Rgb& a, const Rgb& b) {
  return same_bits(a.r, b.r) && same_bits(a.g, b.g) && same_bits(a.b, b.b);
}

}  // namespace twinray
