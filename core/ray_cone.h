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
  /// The same cone, so much narrower.
  RayCone part(float of_it) const { return {width * of_it, spread * of_it}; }
  /// The cone behind a surface that scatters into a direction with this density per solid angle, > 0.
  RayCone scattered(float pdf) const;
};

/// The cone of a camera ray that sees a whole pixel. The camera's frame is that of the picture. In a
/// latitude-longitude picture all are as wide as on the horizon.
RayCone pixel_cone(const Camera& camera, int width, int height);

/// How much of the pixel's cone its sample of this number sees, from 0 on: many samples resolve what one
/// cannot, and must not blur it twice. It is the number that counts, and not how many samples there will be,
/// so that a picture of few samples is the beginning of the picture of more.
inline float part_of_pixel(std::uint32_t sample) {
  return sample < 1 ? 1.0f : sample < 4 ? 1.0f / 2 : sample < 16 ? 1.0f / 4 : 1.0f / 8;
}

/// How wide a cone's section with a surface is, on the average over its directions: the cone is `width` wide
/// where it arrives along a direction of any length.
float section_width(const SurfacePoint& point, float width, const Vec3& direction);
/// The same in texture coordinates.
float texture_footprint(const Geometry& geometry, const Hit& hit, const SurfacePoint& point, float width,
                        const Vec3& direction, CoordinateSet set = CoordinateSet::first);

}  // namespace twinray
