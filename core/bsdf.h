// SPDX-License-Identifier: Apache-2.0
// Scattering at a surface. Directions are unit vectors in the local frame whose z axis is the shading normal:
// wo points to the viewer, wi to the light, both away from the surface. They lie on one side for reflection,
// on two for refraction.
#pragma once
#include <cmath>

#include "core/material.h"
#include "core/vec.h"
#include "core/warp.h"

namespace twinray {

/// A direction in which light is scattered.
struct BsdfSample {
  Vec3 wi;
  Rgb value;      ///< The BSDF f(wo, wi); for a delta lobe, f |cos| is a distribution: f |cos| / pdf is the
                  ///< weight.
  float pdf = 0;  ///< Per solid angle; for a delta lobe the probability of having chosen it. 0: nothing is
                  ///< scattered, and the rest is zero.
  bool is_delta = false;  ///< wi is the only direction of this lobe.
};

/// The scattering function of a material at a point.
class Bsdf {
 public:
  explicit Bsdf(const Material& material);

  /// f(wo, wi), without the cosine. Delta lobes do not take part.
  Rgb evaluate(const Vec3& wo, const Vec3& wi) const {
    return wo.z * wi.z > 0 ? reflectance_ * (1 / pi) : Rgb{};
  }
  /// The density, per solid angle, with which sample() chooses wi.
  float pdf(const Vec3& wo, const Vec3& wi) const;
  /// A direction, from a draw for the lobe and two for the direction within it.
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
  /// Whether sample() uses its draw for the lobe.
  bool has_lobes() const { return false; }
  /// Whether all of it are delta lobes: then light sampling is in vain.
  bool is_delta() const { return false; }
  /// Whether any of it is a delta lobe: then emission may be met that light sampling cannot count.
  bool has_delta() const { return false; }

 private:
  Rgb reflectance_;
};

/// The reflectance of a Lambert surface that stands in for a model: its own, that of a mirror, the
/// transmittance of glass and refraction, the Fresnel reflectance at normal incidence of a conductor.
Rgb lambert_reflectance(const SurfaceModel& model);

}  // namespace twinray
