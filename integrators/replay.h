// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "integrators/path_log.h"
#include "integrators/path_options.h"
#include "integrators/render.h"
#include "integrators/traced_scene.h"

namespace twinray {

/// One sample of a picture, traced again.
struct Replay {
  CameraSample sample;
  PathLog path;
  Rgb radiance;  ///< As the given integrator makes it; path.sum() is the same, bit for bit.
};

/// Traces the path of one sample of a render by PathReference, and makes the sample by the integrator as
/// well, which traces paths by the same options. The pixel lies in the frame. Throws Error for path options
/// out of range.
Replay replay(const TracedScene& of, const PathOptions& path, const RenderOptions& render,
              const PixelSample& sample);

/// Whether two radiances have the same bits; what is not a number has the same as any other such.
bool same_bits(const Rgb& a, const Rgb& b);

}  // namespace twinray
