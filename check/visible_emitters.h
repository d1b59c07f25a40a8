// SPDX-License-Identifier: Apache-2.0
// Pixels in which a light is seen: their noise is that of the light's edges, which hides all other.
#pragma once
#include "accel/accelerator.h"
#include "check/picture_error.h"
#include "core/scene.h"
#include "integrators/render.h"

namespace twinray {

/// The pixels of the window in which no camera ray's first hit is a surface that emits. So many rays are
/// traced for each; an emitter that covers less than their fraction of a pixel may escape them.
PixelMask pixels_without_emitters(const Scene& scene, const Accelerator& accelerator,
                                  const RenderOptions& options, std::uint32_t rays_a_pixel = 256);

}  // namespace twinray
