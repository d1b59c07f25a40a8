// SPDX-License-Identifier: Apache-2.0
// A material at a point, where textures give some of its numbers.
#pragma once
#include <span>

#include "core/material.h"
#include "core/surface.h"
#include "core/texture.h"

namespace twinray {

/// "reflectance", ...
const char* input_name(MaterialInput input);
/// Whether a model has such a number or colour.
bool has_input(const SurfaceModel& model, MaterialInput input);

/// Where a surface's textures are asked for.
inline TexturePoint texture_point(const SurfacePoint& point) {
  return {.uv = point.uv,
          .footprint = point.footprint,
          .draw = point.texture_draw,
          .second_uv = point.second_uv,
          .second_footprint = point.second_footprint,
          .position = point.position,
          .normal = point.geometric_normal,
          .width = point.width};
}

/// The k of a metal of eta 1 of this reflectance where light falls straight on it, as pbrt has it.
Rgb metal_k(const Rgb& reflectance);
/// Alpha of pbrt's roughness, in [0, 1]: its root.
float alpha_of_roughness(float roughness);
/// Sets the roughness and the anisotropy whose facets have these widths: alpha_t = r^2 sqrt(2 / (1 + (1 -
/// a)^2)) along the tangent, and alpha_b = (1 - a) alpha_t <= alpha_t across, as OpenPBR has it.
void set_facets(Principled& model, float along, float across);
/// Makes facets of equal widths wider along the tangent, and keeps them across, as glTF has it: alpha_t =
/// alpha + (1 - alpha) strength^2, strength in [0, 1].
void widen(Principled& model, float strength);
/// Sets the fuzz whose colour times its weight is this, each channel in [0, 1]: the weight is the brightest
/// channel.
void set_fuzz(Principled& model, const Rgb& weighted_color);

/// The material's model with what its textures have at the point, each within its range: eta and k from 0 to
/// 1000, all else in [0, 1]. What widens facets does so after all else is known, and so does what emerges.
SurfaceModel textured_model(const Material& material, std::span<const Texture> textures,
                            const TexturePoint& at);

}  // namespace twinray
