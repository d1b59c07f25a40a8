// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/frame.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// A normal, or its opposite, on the side of another vector.
inline Vec3 facing(const Vec3& normal, const Vec3& side) { return dot(normal, side) < 0 ? -normal : normal; }

/// The axes by which a surface scatters: z is the normal that it shades with, x the tangent where the
/// material's facets are of unequal widths along it and across, so that these widths have their directions.
struct ShadingFrame {
  Frame frame;
  bool is_mapped = false;  ///< The normal is one of a map: not the geometry's, nor interpolated.
};

/// Of a material, not a Mix, at a point seen along the unit vector wo, whose side the normal is on.
ShadingFrame shading_frame(const Scene& scene, const Material& material, const SurfacePoint& point,
                           const Vec3& wo);

}  // namespace twinray
