// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>

#include "core/bsdf_sample.h"
#include "core/elementary.h"
#include "core/material.h"

namespace twinray {

/// Light at a fibre: reflected by its surface (R), let through (TT), let through after a reflection within
/// (TRT), or after more of them. Each of the four lobes is a product: how light spreads along the fibre,
/// around it, and how much of it there is (Chiang et al., "A Practical and Controllable Hair and Fur Model
/// for Production Path Tracing", 2016; the form of pbrt's book, 4th edition, 9.9).
///
/// The frame's x axis runs along the fibre, towards its tip; z is the normal of a round fibre, so that wo
/// says how far from the fibre's axis light meets it. Light goes on from the same point on all sides.
class HairLobe {
 public:
  explicit HairLobe(const Hair& model);

  Rgb albedo() const { return reflectance_; }
  bool lets_light_through() const { return true; }
  /// Works out what evaluations with this wo have in common.
  void look_from(const Vec3& wo) { seen_ = seen(wo); }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  /// `lobe` chooses one of the four, and with u where its light goes.
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;

 private:
  static constexpr std::size_t lobes = 4;
  /// How light spreads along the fibre.
  struct Spread {
    float variance, normalisation;  ///< v, and 1 / (v (1 - e^(-2 / v))).
    SinCos tilt;                    ///< By which the scales turn the lobe.
  };
  /// What is known of a direction to the viewer.
  struct Seen {
    float sine, cosine;                   ///< Of its angle to the plane across the fibre.
    float azimuth;                        ///< Around the fibre from z, in radians.
    std::array<float, lobes - 1> turns;   ///< By how much a ray along the axis of each lobe is turned around.
    std::array<SinCos, lobes> tilted;     ///< The angle to that plane from which each lobe is a reflection.
    std::array<Rgb, lobes> attenuations;  ///< What each lobe keeps of the light,
    std::array<float, lobes> probability;  ///< and that it is chosen.
  };
  Seen seen(const Vec3& wo) const;
  /// By the cosine to the surface's normal, and the way within to the other side, in radii.
  void attenuate(float cosine, float way, Seen& at) const;
  /// How densely light spreads along the fibre from one angle to another, per unit of the latter's sine,
  float along(const Spread& spread, const SinCos& from, const SinCos& to) const;
  /// and around it, per radian, by how far it is turned and how far the axis of its lobe is.
  float around(float azimuth, float turn) const;
  Spread spread(float variance, float tilt_degrees) const;

  Rgb reflectance_, absorption_;
  float ior_;
  std::array<Spread, lobes> spreads_;
  float width_;   ///< s of the logistic distribution around the fibre,
  float inside_;  ///< what of it lies within half a turn to either side,
  float below_;   ///< and what lies below that.
  std::optional<Seen> seen_;
};

/// What fibres absorb per radius of theirs that have this colour together, in many layers; the colour's
/// components in (0, 1], azimuthal roughness in [0, 1] (Chiang et al. 2016, equation 9),
Rgb hair_absorption(const Rgb& reflectance, float azimuthal_roughness);
/// and the colour that they have by it.
Rgb hair_reflectance(const Rgb& absorption, float azimuthal_roughness);

}  // namespace twinray
