// SPDX-License-Identifier: Apache-2.0
// Light from a point: how much of it travels along each direction, and what arrives at a surface.
#pragma once
#include "core/light.h"
#include "core/light_sample.h"
#include "core/surface.h"

namespace twinray {

// Radiant intensity along a unit direction, away from the light; black beyond its cone or its frame.
Rgb intensity_along(const PointLight& light, const Vec3& direction);
Rgb intensity_along(const SpotLight& light, const Vec3& direction);
Rgb intensity_along(const GoniometricLight& light, const Vec3& direction);
Rgb intensity_along(const ProjectionLight& light, const Vec3& direction);

// Radiant power in all directions, where light falls off as 1/d^2; black where it does not, and power has no
// meaning.
Rgb power_of(const PointLight& light);
Rgb power_of(const SpotLight& light);

// What arrives at a surface from the only direction that there is.
LightSample light_from(const PointLight& light, const SurfacePoint& surface);
LightSample light_from(const SpotLight& light, const SurfacePoint& surface);
LightSample light_from(const GoniometricLight& light, const SurfacePoint& surface);
LightSample light_from(const ProjectionLight& light, const SurfacePoint& surface);

}  // namespace twinray
