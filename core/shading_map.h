// SPDX-License-Identifier: Apache-2.0
// Normal maps, bump maps and tangent maps: a surface that shades as if it had detail which its geometry has
// not.
#pragma once
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// Whether a material has a map of either kind.
inline bool has_map(const Material& material) {
  return material.normal_map != no_texture || material.bump_map != no_texture;
}

/// Whether a model's facets are of unequal widths along tangent and bitangent.
bool is_anisotropic(const SurfaceModel& model);
/// The same of a material, whose textures may make them so at some points.
bool is_anisotropic(const Material& material);

/// Whether the tangent of a material's facets is not simply dp/du.
inline bool has_tangent(const Material& material) {
  return is_anisotropic(material) && (material.tangent_degrees != 0 || material.tangent_map != no_texture);
}

/// Whether a material shades by the directions of texture coordinates.
inline bool needs_tangents(const Material& material) { return has_map(material) || is_anisotropic(material); }

/// The unit normal by which a material shades at a point. Of a normal map, red is the part along dp/du, green
/// that along n x dp/du, blue that along n, the point's shading normal, each from -1 (0) to 1; of a bump map,
/// the normal of the surface that is raised by the texture's red along n (Blinn, "Simulation of Wrinkled
/// Surfaces", 1978), but for the part of n's own curvature. Where there are both the normal map counts, as in
/// pbrt. Without maps, or without tangents (core/tangents.h), n itself.
Vec3 mapped_normal(const Scene& scene, const Material& material, const SurfacePoint& point);

/// The tangent of a material's facets of unequal widths at a point where dp/du is known: of any length. Of a
/// tangent map, red is the part along dp/du, green that along n x dp/du, as of a normal map; of one without a
/// direction, dp/du.
Vec3 facet_tangent(const Scene& scene, const Material& material, const SurfacePoint& point, const Vec3& du);

}  // namespace twinray
