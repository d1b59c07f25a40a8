// SPDX-License-Identifier: Apache-2.0
// How wide what a path sees is: a cone around its ray (Akenine-Möller et al., "Improved Shader and Texture
// Level of Detail Using Ray Cones", JCGT 10(1), 2021), from which a texture's level is chosen.
//
// A cone has the width of a pixel where the path begins. A surface that scatters widens it: a direction that
// is chosen with density p stands for a solid angle of about 1/p, so it widens by a part of the square root
// of that (they use the variance of a microfacet lobe; a density serves every lobe alike). A mirror and a
// smooth lens leave the spread as it is, flat or not.
#pragma once
#include "core/camera.h"
#include "core/geometry.h"
#include "core/hit.h"
#include "core/surface.h"

namespace twinray {

struct RayCone {
  float width = 0;   ///< Across, where the ray starts, in scene units; >= 0.
  float spread = 0;  ///< By how much it widens for each unit of distance; >= 0.

  /// The same cone as it arrives at a distance from where the ray starts.
  RayCone at(float distance) const { return {width + spread * distance, spread}; }
  /// The cone behind a surface that scatters into a direction with this density per solid angle, > 0.
  RayCone scattered(float pdf) const;
};

/// With more samples a pixel pictures on surfaces get no sharper.
inline constexpr std::uint32_t sharpest_samples = 64;

/// The cone of all camera rays of a picture: as wide as a pixel or, where a pixel has n samples, as a part of
/// it: 1 / sqrt(n) of up to sharpest_samples, so that what many samples resolve is not blurred twice. The
/// camera's frame is that of the picture. In a latitude-longitude picture all are as wide as on the horizon.
RayCone camera_cone(const Camera& camera, int width, int height, std::uint32_t samples);

/// How wide, in texture coordinates, a cone's section with a surface is, on the average over its directions:
/// the cone is `width` wide where it arrives along a direction of any length.
float texture_footprint(const Geometry& geometry, const Hit& hit, const SurfacePoint& point, float width,
                        const Vec3& direction);

}  // namespace twinray
