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
  Rgb value;      ///< The BSDF f(wo, wi).
  float pdf = 0;  ///< Per solid angle. 0: nothing is scattered, and the rest is zero.
};

/// The scattering function of a material at a point.
class Bsdf {
 public:
  explicit Bsdf(const Material& material);

  /// How much of the light from all around is scattered.
  Rgb albedo() const { return reflectance_; }
  /// f(wo, wi), without the cosine.
  Rgb evaluate(const Vec3& wo, const Vec3& wi) const {
    return wo.z * wi.z > 0 ? reflectance_ * (1 / pi) : Rgb{};
  }
  /// The density, per solid angle, with which sample() chooses wi.
  float pdf(const Vec3& wo, const Vec3& wi) const;
  /// A direction, from two numbers in the unit square.
  BsdfSample sample(const Vec3& wo, Vec2 u) const;

 private:
  Rgb reflectance_;
};

/// The reflectance of a Lambert surface that stands in for a model: its own, that of a mirror, the
/// transmittance of glass and refraction, the Fresnel reflectance at normal incidence of a conductor.
Rgb lambert_reflectance(const SurfaceModel& model);

}  // namespace twinray
