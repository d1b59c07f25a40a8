// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/lobes/coat.h"
#include "core/lobes/rough_conductor.h"
#include "core/lobes/specular.h"

namespace twinray {

/// A smooth metal under a smooth coat: a mirror, with all reflections between the two. wo.z > 0.
class SmoothCoatedConductorLobe : public DeltaLobe {
 public:
  /// The coat's ior; the metal's eta and k relative to the coat, and a factor of its reflectance.
  SmoothCoatedConductorLobe(float ior, const Rgb& eta, const Rgb& k, const Rgb& reflectance)
      : ior_(std::max(1.0f, ior)), eta_(eta), k_(k), reflectance_(reflectance) {}

  Rgb albedo() const { return reflected(1); }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  Rgb reflected(float cosine) const;

  float ior_;
  Rgb eta_, k_, reflectance_;
};

/// A metal under a coat, one of them rough at least. Exact is what the coat reflects, and for a smooth coat
/// what light brings that meets the metal once. More reflections in between stay in the metal's lobe as far
/// as the coat would reflect them if the metal were smooth; what is reflected totally, since the metal
/// scattered it far, ends as a diffuse lobe, so that a white metal loses nothing. A rough coat counts as a
/// smooth one over a rougher metal. docs/materials.md compares it with a walk through the layers. Reciprocal;
/// wo.z > 0.
class CoatedConductorLobe {
 public:
  /// The metal's facets; its eta and k relative to the coat, and a factor of its reflectance.
  CoatedConductorLobe(const Coat& coat, const Ggx& facets, const Rgb& eta, const Rgb& k,
                      const Rgb& reflectance);

  Rgb albedo() const;
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  /// The probabilities of sampling the coat's reflection and the metal's; what is left is diffuse.
  struct Choice {
    float coat, metal;
  };
  Choice choice(float cosine) const;
  /// The direction within the coat that w is refracted to, turned to point up.
  Vec3 below(const Vec3& w) const;
  /// The part of light along a direction that is kept below the coat, beyond what a smooth metal would keep.
  float kept(float cosine) const;

  Coat coat_;
  RoughConductorLobe metal_;
  float log_alpha_;  ///< Of the metal's facets.
  float mean_kept_;  ///< kept() of light from all directions.
  Rgb diffuse_;      ///< Of light that is kept: the part that leaves in the end.
};

}  // namespace twinray
