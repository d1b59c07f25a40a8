// SPDX-License-Identifier: Apache-2.0
// Light that media emit along a ray.
#pragma once
#include "core/ray.h"
#include "core/rgb.h"
#include "core/scene.h"

namespace twinray {

/// The radiance that a medium itself adds along a stretch of a ray, from where it begins to its parameter t,
/// as it comes to that beginning: the integral of the emission, dimmed by the medium on the way. Exact where
/// the glow is even, whatever the density. Else an unbiased estimate by the glow of points that u in
/// [0, 1) chooses as if it were even.
Rgb medium_glow(const Scene& scene, const Interior& medium, const Ray& ray, float t, float u);

}  // namespace twinray
