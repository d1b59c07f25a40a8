// SPDX-License-Identifier: Apache-2.0
// Scattering at a surface. Directions are unit vectors in the local frame whose z axis is the shading normal:
// wo points to the viewer, wi to the light, both away from the surface. They lie on one side for reflection,
// on two for transmission.
#pragma once
#include <variant>

#include "core/bsdf_sample.h"
#include "core/lobes/coated_conductor.h"
#include "core/lobes/coated_diffuse.h"
#include "core/lobes/cs184_microfacet.h"
#include "core/lobes/diffuse_transmission.h"
#include "core/lobes/hair.h"
#include "core/lobes/lambert.h"
#include "core/lobes/measured.h"
#include "core/lobes/principled.h"
#include "core/lobes/rough_conductor.h"
#include "core/lobes/rough_dielectric.h"
#include "core/lobes/rough_diffuse.h"
#include "core/lobes/specular.h"
#include "core/material.h"

namespace twinray {

/// On which side of a surface the viewer is; outside is where the normal points that the scene gave it.
enum class Side { outside, inside };

/// The scattering function of a model at a point: one of a closed set of lobes, each a small class with these
/// functions.
class Bsdf {
 public:
  /// Not of a Mix, which stands for one of its two materials at each point.
  explicit Bsdf(const SurfaceModel& model, Side side = Side::outside);

  /// How much of the light from all around is scattered, about; in [0, 1].
  Rgb albedo() const {
    return std::visit([](const auto& lobe) { return lobe.albedo(); }, lobes_);
  }
  /// Whether light is reflected evenly, on the viewer's side alone.
  bool is_lambert() const { return std::holds_alternative<LambertLobe>(lobes_); }
  /// Whether light from behind the surface may reach the viewer otherwise than straight on, or refracted by a
  /// smooth boundary.
  bool lets_light_through() const;
  /// Its lobe, if that is of this class; else null.
  template <typename Lobe>
  const Lobe* as() const {
    return std::get_if<Lobe>(&lobes_);
  }
  /// Whether look_from() does anything.
  bool looks_ahead() const { return as<PrincipledLobe>() || as<HairLobe>(); }
  /// Works out beforehand what the next calls with this wo have in common; changes no bit.
  void look_from(const Vec3& wo) {
    if (auto* const lobe = std::get_if<PrincipledLobe>(&lobes_)) lobe->look_from(wo);
    if (auto* const lobe = std::get_if<HairLobe>(&lobes_)) lobe->look_from(wo);
  }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const {
    return std::visit([&](const auto& lobe) { return lobe.evaluate(wo, wi); }, lobes_);
  }
  /// What of it the matte part of the surface scatters, towards the side of wo.
  Rgb diffuse(const Vec3& wo, const Vec3& wi) const;
  /// What light below the surface may stand for; nothing of most lobes.
  BelowSurface below(const Vec3& wo) const;
  /// What of evaluate() is that.
  Rgb of_below(const Vec3& wo, const Vec3& wi) const;
  /// How light leaves the surface that comes from all directions below, in place of f: its integral with the
  /// cosine is 1.
  Rgb from_below(const Vec3& wi) const;
  /// A direction, from a number in [0, 1) that chooses among ways of scattering and two in the unit square.
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const {
    return std::visit([&](const auto& l) { return l.sample(wo, lobe, u); }, lobes_);
  }

  using Lobes =
      std::variant<LambertLobe, MirrorLobe, SmoothConductorLobe, SmoothDielectricLobe, RefractionLobe,
                   ThinDielectricLobe, PassageLobe, RoughConductorLobe, RoughDielectricLobe,
                   Cs184MicrofacetLobe, DiffuseTransmissionLobe, RoughDiffuseLobe, CoatedDiffuseLobe,
                   SmoothCoatedConductorLobe, CoatedConductorLobe, PrincipledLobe, HairLobe, MeasuredLobe>;

 private:
  Lobes lobes_;
};

}  // namespace twinray
