// SPDX-License-Identifier: Apache-2.0
// Lobes of smooth surfaces: all light goes along one direction, or two, so there is nothing to evaluate for
// others.
#pragma once
#include <optional>

#include "core/bsdf_sample.h"
#include "core/thin_film.h"

namespace twinray {

/// What lobes of delta directions alone have in common.
struct DeltaLobe {
  BsdfValue evaluate(const Vec3&, const Vec3&) const { return {}; }
};

/// A perfect mirror.
struct MirrorLobe : DeltaLobe {
  Rgb reflectance;

  explicit MirrorLobe(const Rgb& r) : reflectance(r) {}
  Rgb albedo() const { return reflectance; }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

/// A smooth metal: a mirror that reflects by Fresnel's equations.
struct SmoothConductorLobe : DeltaLobe {
  Rgb eta, k;
  Rgb reflectance;  ///< A factor.

  SmoothConductorLobe(const Rgb& index, const Rgb& absorption, const Rgb& factor)
      : eta(index), k(absorption), reflectance(factor) {}
  Rgb albedo() const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

/// A smooth boundary between two media: reflects and refracts by Fresnel's equations.
struct SmoothDielectricLobe : DeltaLobe {
  float eta;                       ///< Index of refraction on the other side, to that on the viewer's.
  Rgb reflectance, transmittance;  ///< Factors.

  SmoothDielectricLobe(float ratio, const Rgb& reflected, const Rgb& transmitted)
      : eta(ratio), reflectance(reflected), transmittance(transmitted) {}
  Rgb albedo() const { return transmittance; }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

/// A smooth boundary that refracts all light; where none can be refracted, nothing is scattered.
struct RefractionLobe : DeltaLobe {
  float eta;  ///< As above.
  Rgb transmittance;

  RefractionLobe(float ratio, const Rgb& factor) : eta(ratio), transmittance(factor) {}
  Rgb albedo() const { return transmittance; }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

/// No surface: light goes straight on.
struct PassageLobe : DeltaLobe {
  Rgb albedo() const { return {1, 1, 1}; }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

/// A smooth sheet: both boundaries of a dielectric in one surface, with all reflections between them. Light
/// goes straight on.
struct ThinDielectricLobe : DeltaLobe {
  float eta;                        ///< Index of refraction within the sheet, to that outside.
  Rgb reflectance, transmittance;   ///< Factors.
  std::optional<PartialFilm> film;  ///< On each boundary.
  bool is_single = false;           ///< There is one boundary: a film between media that are alike.

  ThinDielectricLobe(float ratio, const Rgb& reflected, const Rgb& transmitted,
                     const std::optional<PartialFilm>& on_each = {}, bool has_one_boundary = false)
      : eta(ratio),
        reflectance(reflected),
        transmittance(transmitted),
        film(on_each),
        is_single(has_one_boundary) {}
  Rgb albedo() const { return transmittance; }
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
};

}  // namespace twinray
