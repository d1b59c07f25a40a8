// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "core/ray.h"
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray {

/// Light that may arrive at a surface from one light, before anything is in its way.
struct LightSample {
  Vec3 direction;  ///< Unit, from the surface to the light; zero where the radiance is black.
  Rgb radiance;    ///< Arriving; for a delta light, irradiance on a surface that faces it. Black for none at
                   ///< all.
  float pdf = 1;   ///< Per solid angle; 1 for a delta light.
  Ray shadow_ray;  ///< The light arrives if nothing blocks it.
  std::uint32_t light = 0;  ///< Of a group of lights: the one that was chosen.
};

}  // namespace twinray
