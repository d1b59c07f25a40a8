// SPDX-License-Identifier: Apache-2.0
// Private: the one door through which rays reach an accelerator.
//
// A ray is checked against the domain of core/ray.h and everything is derived here that the canonical tests
// (slab.h, triangle.h, sphere.h) need of it, so that every backend computes with the same bits. A direction
// whose largest component lies outside [2^-40, 2^40] is scaled by a power of two, and t with it; t is scaled
// back on a hit.
#pragma once
#include "core/lanes.h"
#include "core/ray.h"
#include "core/vec.h"

namespace twinray {

struct CheckedRay {
  Vec3 origin;
  Vec3 direction;  ///< Scaled: its largest component lies in [2^-40, 2^40].
  /// In units of the scaled direction; a t up to t_max is finite, here and for the caller.
  float t_min, t_max;
  /// Multiplies a t of the scaled ray into a t of the caller's ray: a power of two, as a double because those
  /// of float end before the directions do.
  double t_scale;

  // Slab test, in the first three lanes: the origin moved by its share of the rounding bound, and the
  // reciprocal scaled by its own.
  Float4 near_origin, far_origin;
  Float4 near_inverse, far_inverse;
  Int4 is_negative;  ///< 1 where the direction's sign bit is set; -0.0 counts as negative.

  // Woop's shear: the axes turned so that kz is the dominant one, and the direction brought to (0, 0, 1).
  int kx, ky, kz;
  float sx, sy, sz;
  float ox, oy, oz;  ///< The origin's components kx, ky, kz.
};

/// Fills `checked`; false for an invalid ray, which is a miss.
bool load_ray(const Ray& ray, CheckedRay& checked) noexcept;

/// The relative bound by which the slab test widens boxes, origins and reciprocals: eight units in the last
/// place.
///
/// With u = 2^-24 and D the largest component of vertex - origin, Woop's test rounds each sheared vertex by
/// up to u (2 |a - o| + 4 |a_z - o_z|), at most 6 u D in each of its two components; the point of its weights
/// is beside the ray by no more. D is at most the largest coordinate of the box plus the origin's. Widening
/// the box and the origin by 8 u each, 7 u after the rounding of that step, keeps whatever the test accepts
/// inside of the box. The reciprocal's, the difference's and the product's rounding come to 4 u; the
/// reciprocal is scaled by 8 u, outward where t >= 0. (Where t < 0 that is inward, and a hit there is none.)
inline constexpr float slab_margin = 0x1p-21f;

}  // namespace twinray
