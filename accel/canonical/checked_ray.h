// SPDX-License-Identifier: Apache-2.0
// Private: the one door through which rays reach an accelerator.
//
// A ray is checked against the domain of core/ray.h and everything is derived here that the canonical tests
// (slab.h, triangle.h, sphere.h) need of it, so that every backend computes with the same bits: once plainly,
// and with the same bits in lanes (load_ray.cpp, and load_ray-inl.h for newer machines). A direction whose
// largest component lies outside [2^-40, 2^40] is scaled by a power of two, and t with it; t is scaled back
// on a hit.
#pragma once
#include <cstdint>
#include <limits>

#include "core/hit.h"
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
  /// In whose space the ray is given; no_instance: in the scene's.
  std::uint32_t instance;

  // Slab test, in the first three lanes: the origin moved by its share of the rounding bound, and the
  // reciprocal scaled by its own.
  Float4 near_origin, far_origin;
  Float4 near_inverse, far_inverse;
  Int4 is_negative;  ///< 1 where the direction's sign bit is set; -0.0 counts as negative.

  // Woop's shear, in the first three lanes: the axes turned so that the last one is the dominant one, and the
  // direction brought to (0, 0, 1).
  Int4 axes;
  Float4 shear;
  Float4 turned_origin;  ///< The origin's components in the order of `axes`.

  /// A hit of the scaled ray in the caller's units.
  void scale_back(Hit& hit) const {
    if (t_scale != 1) hit.t = float(hit.t * t_scale);
  }
};

/// Fills `checked`; false for an invalid ray, which is a miss. The plain form: the oracle of load_ray, and of
/// load_ray-inl.h.
bool load_ray_scalar(const Ray& ray, CheckedRay& checked) noexcept;

/// The same bits, in lanes: what the engines call.
bool load_ray(const Ray& ray, CheckedRay& checked) noexcept;

// What load_ray is made of, for whoever does the same in another way.

/// The components of an origin are no larger.
inline constexpr float max_origin = 0x1p60f;
/// Between these lies the largest component of a direction that is taken as it is.
inline constexpr float min_direction = 0x1p-40f, max_direction = 0x1p40f;
/// A component of a direction is taken for no smaller than this part of the largest one, so that its
/// reciprocal stays finite; what that moves a ray by is far below slab_margin.
inline constexpr float least_component = 0x1p-60f;
/// A t_max is brought down to this.
inline constexpr float max_t = std::numeric_limits<float>::max();

/// Brings the direction, with components of any size, into range, and t with it; false for the zero vector.
bool scale_direction(CheckedRay& checked) noexcept;

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
