// SPDX-License-Identifier: Apache-2.0
// How much of the light that falls on GGX facets they scatter after one reflection, as tables: what is
// missing is light that meets several facets, and light below a rough coat.
#pragma once
#include <array>

#include "core/microfacet.h"
#include "core/rgb.h"

namespace twinray {

/// The part of light along a direction that facets of one alpha, which absorb nothing, reflect to other
/// facets instead of away: 1 - the integral of D G / (4 wo.z). cosine and alpha in [0, 1]. Within 3e-3.
float ggx_loss(float cosine, float alpha);
/// The same for light that is the same from all directions: the integral of 2 cos ggx_loss(cos). Within 2e-3.
float average_ggx_loss(float alpha);

/// The part of light along a direction that facets of a dielectric reflect at once: the integral of
/// F D G / (4 wo.z). alpha in [0, 1], ior (to the side of the light) of at least 1. Within 5e-3, 2e-2
/// within 0.1 of the horizon; for an ior above 3 within 0.015 and 0.05.
float ggx_dielectric_reflectance(float cosine, float alpha, float ior);

/// The same for one alpha and ior.
class GgxDielectricReflectance {
 public:
  GgxDielectricReflectance(float alpha, float ior);
  float operator()(float cosine) const;
  /// The same for light that is the same from all directions. Within 3e-3; above 3 within 0.015.
  float average() const { return average_; }
  /// The reflectances at cosines whose roots are equally spaced over [0, 1]; between them it is linear.
  const std::array<float, 16>& row() const { return row_; }

 private:
  std::array<float, 16> row_;
  float average_;
};

/// The part of light along a direction that facets of a boundary between two media reflect or refract to
/// other facets, instead of away. alpha in [0, 1]; eta, the index of refraction behind to that in front, is
/// taken as within [1/3, 3]. Within 0.03.
float ggx_boundary_loss(float cosine, float alpha, float eta);
/// The same for light that is the same from all directions. Within 0.02.
float average_ggx_boundary_loss(float alpha, float eta);

/// What GGX facets reflect after light met several of them: nearly diffuse, reciprocal, and as much as is
/// missing (Kulla and Conty, "Revisiting Physically Based Shading at Imageworks", 2017).
class MultipleScattering {
 public:
  explicit MultipleScattering(const Ggx& facets);

  /// The part of light along a direction, w.z > 0, that meets several facets.
  float loss(const Vec3& w) const;
  /// The mean of that around the normal, about.
  float loss(float cosine) const { return ggx_loss(cosine, alpha_); }
  /// Of facets without direction that lose about as much.
  float alpha() const { return alpha_; }
  /// The part of light that is the same from all directions.
  float average_loss() const { return average_loss_; }
  /// f(wo, wi) of facets that absorb nothing; both z > 0.
  float evaluate(const Vec3& wo, const Vec3& wi) const;
  /// The factor of that for facets whose reflectance is `average` over all directions: some is absorbed at
  /// each of the reflections.
  Rgb absorption(const Rgb& average) const;

 private:
  Ggx facets_;
  float alpha_, average_loss_;
};

/// The same for a boundary between two media: what its facets lose at once leaves nearly diffuse on both
/// sides, shared as all of the light from all directions is, as far as reciprocity allows.
class DielectricMultipleScattering {
 public:
  /// eta: index of refraction on the other side, to that on the viewer's.
  DielectricMultipleScattering(const Ggx& facets, float eta);

  /// The part of light along a direction on the viewer's side, w.z > 0, that meets several facets.
  float loss(const Vec3& w) const { return loss(w, eta_); }
  /// The part of that which is reflected in the end, in [0, 1].
  float reflected_part() const { return reflected_; }
  /// f(wo, wi), both on the viewer's side.
  float reflection(const Vec3& wo, const Vec3& wi) const;
  /// f(wo, wi) of radiance; wo on the viewer's side, wi on the other.
  float transmission(const Vec3& wo, const Vec3& wi) const;

 private:
  /// From a side whose other side has an index of refraction of eta to it.
  float loss(const Vec3& w, float eta) const;
  float average_loss(float eta) const;

  Ggx facets_;
  float alpha_, eta_;
  float reflected_;
  float reflected_scale_, transmitted_scale_;  ///< Of the product of both directions' losses.
};

}  // namespace twinray
