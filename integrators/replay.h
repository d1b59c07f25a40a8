// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "accel/accelerator.h"
#include "core/scene.h"
#include "integrators/integrator.h"
#include "integrators/path_log.h"
#include "integrators/path_options.h"
#include "integrators/render.h"

namespace twinray {

/// One sample of a picture, traced again.
struct Replay {
  CameraSample sample;
  PathLog path;
  Rgb radiance;  ///< As the given integrator makes it; path.sum() is the same, bit for bit.
};

/// What is rendered.
struct ReplayScene {
  const Scene& scene;
  const Accelerator& accelerator;
  const Integrator& integrator;  ///< Traces paths by the options that replay() gets.
};

/// Traces the path of one sample of a render by PathReference, and makes the sample by the integrator as
/// well. The pixel lies in the frame. Throws Error for path options out of range.
Replay replay(const ReplayScene& of, const PathOptions& path, const RenderOptions& render,
              const PixelSample& sample);

/// Whether two radiances have the same bits; what is not a number has the same as any other such.
bool same_bits(const Rgb& a, const Rgb& b);

}  // namespace twinray
