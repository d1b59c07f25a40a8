// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <variant>

#include "core/lobes/coat.h"
#include "core/lobes/fuzz.h"
#include "core/lobes/rough_dielectric.h"
#include "core/lobes/rough_diffuse.h"
#include "core/lobes/specular.h"
#include "core/material.h"

namespace twinray {

/// How a metal reflects that is described by two colours, along its normal and near the rim: Schlick's curve,
/// darkened by a tint at 82 degrees (Hoffman 2023; OpenPBR's).
class TintedFresnel {
 public:
  /// Both in [0, 1].
  TintedFresnel(const Rgb& normal, const Rgb& rim);
  const Rgb& normal() const { return normal_; }
  /// What is taken away by the tint: the factor of cos (1 - cos)^6.
  const Rgb& dip() const { return dip_; }
  Rgb operator()(float cosine) const;
  /// Of light from all directions: the integral of 2 cos F(cos).
  Rgb average() const;

 private:
  Rgb normal_, dip_;
};

/// A principled surface of metal and gloss alone: facets of one alpha, and nothing on them.
struct BarePrincipled {
  float metal;   ///< Weight of the metal's reflection,
  float opaque;  ///< and of the glossy diffuse surface.
  const TintedFresnel& metal_fresnel;
  const MultipleScattering& multiple;
  const Rgb& metal_multiple;  ///< A factor of what meets several facets of the metal.
  const Coat& gloss;
  const Rgb& specular_color;
  const Rgb& diffuse;             ///< The radiosity below the gloss,
  const RoughDiffuseLobe& rough;  ///< and its shape, white.
};

/// OpenPBR's surface (version 1.1): a metal, a glossy diffuse surface and a boundary to something clear,
/// mixed by weight; on them a coat, and on it fuzz. Each layer lets through what it does not reflect. wo.z >
/// 0.
class PrincipledLobe {
 public:
  PrincipledLobe(const Principled& model, bool is_inside);

  /// Works out beforehand what depends on wo alone, for the calls with this wo that follow; changes no bit.
  void look_from(const Vec3& wo) { seen_ = seen(wo); }
  /// All that it is made of, where that is no more than this; of parts of the lobe.
  std::optional<BarePrincipled> bare() const;

  Rgb albedo() const;
  bool lets_light_through() const { return clear_ > 0; }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  /// What of it comes from the opaque base below the gloss, and from the fuzz.
  Rgb diffuse(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, float lobe, Vec2 u) const;
  BelowSurface below(const Vec3& wo) const;
  Rgb of_below(const Vec3& wo, const Vec3& wi) const;
  Rgb from_below(const Vec3& wi) const;

 private:
  /// What coat and fuzz let through; all of the light where they are not there.
  struct Layers {
    float coat = 1, fuzz = 1;
  };
  /// Probabilities of the ways of scattering; their sum is 1.
  struct Choice {
    float fuzz, coat, facets, diffuse, clear;
  };
  /// What depends on the viewer's direction alone.
  struct Seen {
    Vec3 wo = {};  ///< In no direction: nothing is known.
    Choice choice = {};
    Rgb through_gloss = {};
    Layers past = {};
  };
  Seen seen(const Vec3& wo) const;
  Choice choice(const Seen& from) const;
  BsdfValue evaluate(const Seen& from, const Vec3& wi) const;
  /// What passes the layers along a direction; from below, in the mean about all directions.
  Layers past(float cosine) const;
  /// What the layers leave of light that passes them in and out, scattered between by facets of a width from
  /// 0 (a mirror) to 1, or by what is diffuse: 1. Reciprocal, and in the mean about all of the light that
  /// passes along one of both. For light that goes through the surface, and so passes each layer once, the
  /// width is 1.
  Rgb through_layers(const Layers& in, const Layers& out, float width) const;
  /// What metal and glossy diffuse surface reflect, through coat and fuzz; wi.z > 0.
  BsdfValue evaluate_opaque(const Seen& from, const Vec3& wi, const Layers& out, const Rgb& of_facets) const;
  /// What facets of metal and of gloss reflect; the latter without its colour.
  Rgb metal_reflectance(float cosine) const;
  Rgb gloss_reflectance(float cosine) const;
  /// What the diffuse base reflects, over all that goes in and out of it; the subsurface's part is Lambert's.
  Rgb matte(const Vec3& wo, const Vec3& wi) const {
    const Rgb rough = (white - subsurface_) * rough_.evaluate(wo, wi).value;
    return diffuse_ * (rough + subsurface_ * (1 / pi));
  }
  /// What of light to the base and from it passes gloss and layers.
  Rgb through_all(const Seen& seen, const Vec3& wi) const {
    return through_gloss(wi) * seen.through_gloss * through_layers(seen.past, past(wi.z), 1) * opaque_;
  }
  /// What the gloss lets through along a direction.
  Rgb through_gloss(const Vec3& w) const { return through_gloss(w.z, gloss_.reflectance(w)); }
  /// The same, where the gloss reflects so much without a film.
  Rgb through_gloss(float cosine, float reflectance) const;
  /// Works out what the film changes of light from all directions.
  void set_film(const Principled& model);
  void set_coat(const Principled& model);
  Rgb base_albedo() const;
  BsdfSample sample(const Seen& from, float lobe, Vec2 u) const;
  BsdfSample sample_clear(const Seen& from, float lobe, Vec2 u) const;
  /// f(seen along wo): by what is known of that direction, or worked out now.
  template <typename F>
  auto from(const Vec3& wo, const F& f) const {
    return wo == seen_.wo ? f(seen_) : f(seen(wo));
  }

  float metal_, opaque_, clear_;  ///< Weights of the base's three; their sum is 1.
  float specular_weight_, coat_weight_, fuzz_weight_;
  Rgb specular_color_, fuzz_color_;
  Ggx facets_;   ///< Of metal and gloss,
  float width_;  ///< and how widely they scatter, as through_layers has it.
  MultipleScattering multiple_;
  TintedFresnel metal_fresnel_;
  std::optional<PartialFilm> film_;  ///< On metal and gloss, where they are seen from above.
  Rgb metal_ior_;                    ///< Below the film.
  Rgb metal_average_;                ///< What metal facets reflect of light from all directions.
  Rgb metal_multiple_;               ///< A factor of what meets several facets.
  Coat gloss_;
  Rgb gloss_average_;  ///< What the gloss reflects of light from all directions.
  float subsurface_weight_;
  Rgb subsurface_color_;
  Rgb reflectance_;         ///< Of all that is diffuse,
  Rgb diffuse_;             ///< and the radiosity below the gloss, Coat::diffuse_below.
  Rgb subsurface_;          ///< The part of it that is the subsurface's,
  RoughDiffuseLobe rough_;  ///< and the shape of the rest, white.
  // Where their weights are not 0:
  std::optional<std::variant<RoughDielectricLobe, ThinDielectricLobe>> boundary_;
  std::optional<Coat> coat_;
  float coat_width_ = 1;
  std::optional<Fuzz> fuzz_;
  Layers through_;          ///< Of light from all directions.
  Rgb below_coat_ = white;  ///< A factor of what is below the coat: its colour, and reflections back.
  Seen seen_;
};

}  // namespace twinray
