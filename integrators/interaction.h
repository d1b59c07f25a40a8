// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <optional>

#include "core/bsdf_table.h"
#include "core/light_patch.h"
#include "core/phase_function.h"
#include "core/shadow_terminator.h"
#include "core/surface.h"
#include "integrators/shading_frame.h"

namespace twinray {

/// On which side of a surface a viewer is, in a direction from there.
Side side_of(const SurfacePoint& point, const Vec3& wo);

/// A point where light is scattered together with the direction it is seen from: what scattering needs.
/// Mostly a point of a surface; else one in a medium, all directions from which lie in the medium.
///
/// Both normals are turned to the viewer's side. Where interpolated normals contradict the geometry (the
/// viewer lies behind the shading normal), the geometric one shades. Outside is where the shape's shading
/// normals point, if it has any, else its fronts. The table of scattering functions must outlive it.
class Interaction {
 public:
  /// `wo` is a unit vector to the viewer.
  Interaction(const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo, const Viewing& viewing = {});

  /// Of a point in a medium, seen by whom `viewing` says to be in it. Its normal is wo.
  static Interaction in_medium(const Scene& scene, const Vec3& position, const Vec3& wo,
                               const Viewing& viewing);

  /// Of a point of the surface of a material where a path comes out of the body, to that side of it.
  static Interaction emerging(const BsdfTable& bsdfs, const SurfacePoint& point, std::uint32_t material,
                              const Vec3& outward, const Viewing& viewing);
  /// From now on light that goes below the surface (core/subsurface.h) is none that this scatters: where
  /// goes_below(lobe), the path goes there.
  void keep_above() { part_ = Part::above; }
  /// Works out beforehand what is the same for all directions of light; changes no bit.
  void look_ahead() { bsdf_.look_from(wo_local_); }

  bool is_in_medium() const { return phase_.has_value(); }
  /// In a medium it is a point that rays leave as they are.
  const SurfacePoint& point() const { return point_; }
  /// Index into the scene's materials; in a medium of the one whose interior that is.
  std::uint32_t material() const { return material_; }
  /// Of a surface.
  const Bsdf& bsdf() const { return *bsdf_; }
  /// How much of the light from all around is scattered, about; in [0, 1].
  Rgb albedo() const { return phase_ ? Rgb{1, 1, 1} : bsdf_->albedo(); }
  /// From now on the table need not outlive it.
  void keep_bsdf() { bsdf_.keep(); }
  /// Whether light is scattered evenly, so that light samples bring nearly all of it well.
  bool is_lambert() const { return bsdf_->is_lambert(); }
  /// Whether a path has come out of the body here.
  bool is_emerging() const { return part_ == Part::emerging; }
  /// On which side of the surface the viewer is.
  Side side() const { return side_; }
  const Vec3& wo() const { return wo_; }              ///< World space.
  const Vec3& wo_local() const { return wo_local_; }  ///< z > 0.
  const Vec3& normal() const { return shading_.frame.normal; }
  Receiver receiver() const {
    if (phase_) return {point_.position, {}, true};
    return {point_.position, normal(), bsdf_->lets_light_through()};
  }

  const Frame& frame() const { return shading_.frame; }
  /// Whether a map bends the normal: then kept() is not always 1.
  bool is_mapped() const { return shading_.is_mapped; }

  Vec3 to_local(const Vec3& v) const { return shading_.frame.to_local(v); }
  Vec3 to_world(const Vec3& v) const { return shading_.frame.to_world(v); }
  /// f(wo, wi) |cos(wi)| for a unit direction in world space, and the density with which scattering chooses
  /// it, of all but delta directions. Black where wi leaves on another side of the surface than of its
  /// shading normal, so that no light leaks through.
  /// In a medium it is the phase function, without a cosine.
  BsdfValue scattered(const Vec3& wi) const {
    const Vec3 local = to_local(wi);
    if (phase_) return phase_value(local);
    const auto [value, pdf] = value_of_part(local);
    return {is_consistent(wi) ? value * (std::fabs(local.z) * kept(wi)) : Rgb{}, pdf};
  }
  /// A direction of scattered light, as Bsdf::sample() gives it. Where goes_below(lobe), it is one below the
  /// surface, with the value of a base that reflects all of the light: the walk there (walk_below.h) loses
  /// what the base would absorb.
  BsdfSample sample(float lobe, Vec2 u) const;
  /// Whether the draw `lobe` lets a path go below the surface.
  bool goes_below(float lobe) const { return part_ == Part::above && is_below(lobe); }
  /// Of the base that stands for the body.
  Rgb reflectance_below() const { return bsdf_->below(wo_local_).reflectance; }
  /// The cosine that belongs to a sample's value, >= 0; in a medium there is none: 1.
  float cosine(const BsdfSample& sample) const { return phase_ ? 1 : std::fabs(sample.wi.z); }
  /// Whether light from a direction goes through the surface; all light goes through media.
  bool transmits(const Vec3& wi) const { return phase_ || to_local(wi).z < 0; }
  /// The part of scattered(wi) that the matte part of the surface scatters, channel by channel, in [0, 1].
  Rgb diffuse_share(const Vec3& wi) const;
  /// The part of light from a consistent direction that is left where a map bends the normal, softly falling
  /// to 0 where the geometry no longer sees it (core/shadow_terminator.h); without a map 1.
  float kept(const Vec3& wi) const {
    if (!shading_.is_mapped) return 1;
    return shadow_terminator(std::fabs(dot(facing_normal_, wi)), terminator_alpha_squared());
  }
  /// Of shadow_terminator(); without a map 0, with which that is 1.
  float terminator_alpha_squared() const {
    return is_mapped() ? twinray::terminator_alpha_squared(dot(facing_normal_, normal())) : 0;
  }
  /// Whether a direction lies on one side of both the shading and the geometric normal; a fibre has no sides.
  bool is_consistent(const Vec3& wi) const {
    if (is_fibre_) return true;
    return (dot(facing_normal_, wi) > 0) == (dot(shading_.frame.normal, wi) > 0);
  }

  /// Where a direction leads: before the surface, where the viewer is, or behind it.
  const Interiors& interiors(const Vec3& wi) const { return dot(facing_normal_, wi) > 0 ? before_ : behind_; }

  /// What a path is in that goes straight on through a surface, and was in `before` where it came from; `wo`
  /// is a vector to there.
  static Interiors interiors_behind(const Scene& scene, const SurfacePoint& point, const Vec3& wo,
                                    const Interiors& before);

 private:
  /// How a path meets a surface.
  struct Meeting {
    std::uint32_t material;
    Side side;
    Interiors within;  ///< What it is in, as the surface has it (interaction.cpp).
  };
  static Meeting meet(const Scene& scene, const SurfacePoint& point, const Vec3& wo,
                      const Interiors& interiors);
  Interaction(const BsdfTable& bsdfs, const SurfacePoint& point, const Vec3& wo, const Viewing& viewing,
              const Meeting& meeting);

  Interaction(PhaseFunction phase, std::uint32_t material, const SurfacePoint& point, const Vec3& wo,
              const Interiors& interiors);
  BsdfValue phase_value(const Vec3& local) const;
  /// What of the surface's scattering function this is.
  enum class Part : std::uint8_t {
    whole,
    above,     ///< Without what goes below,
    emerging,  ///< or what comes out from there.
  };
  BsdfValue value_of_part(const Vec3& local) const {
    return part_ == Part::whole ? bsdf_->evaluate(wo_local_, local) : value_of_layers(local);
  }
  BsdfValue value_of_layers(const Vec3& local) const;
  bool is_below(float lobe) const;
  BsdfSample sample_below(Vec2 u) const;

  SurfacePoint point_;
  std::uint32_t material_;
  Vec3 wo_;
  Vec3 facing_normal_;  ///< The geometric normal on the viewer's side.
  ShadingFrame shading_;
  Vec3 wo_local_;
  BsdfAt bsdf_;
  std::optional<PhaseFunction> phase_;  ///< Of a point in a medium.
  Interiors before_, behind_;
  Part part_ = Part::whole;
  Side side_ = Side::outside;
  bool is_fibre_ = false;
};

}  // namespace twinray
