// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "core/bsdf_sample.h"
#include "core/rgb.h"
#include "core/square_density.h"

namespace twinray {

/// What a goniophotometer saw of a material, as tables of functions on the unit square: normals of facets
/// (with the square's x for their angle from the surface's normal, y for their azimuth), or uniform points
/// that visible normals are sampled by. Angles are in radians. Names as in Dupuy and Jakob, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering", 2018.
struct BrdfMeasurement {
  std::vector<float> phi, theta;  ///< Azimuths and angles from the normal of the directions measured from.
  SquareTable<float> ndf;         ///< How the facets' normals are distributed: one slice.
  SquareTable<float> sigma;       ///< The facets' area as seen from each direction: one slice.
  SquareTable<float> vndf;        ///< Of visible normals: a slice for each theta of each phi,
  SquareTable<float> luminance;   ///< of how bright the light is that they reflect,
  SquareTable<Rgb> reflected;     ///< and of what they reflect:
  bool is_relative_to_facets = true;  ///< divided by ndf / (4 sigma), or else f(wo, wi) wi.z itself.
};

/// A measured material that reflects. wo.z > 0, as the frame of core/bsdf.h has it; of an anisotropic one the
/// x axis is the direction of azimuth 0.
class MeasuredBrdf {
 public:
  /// Throws Error where the tables' sizes do not fit, angles do not increase or are out of range, or a number
  /// is negative or not finite. Azimuths reach around the whole circle, a half or a quarter of it: then the
  /// material is the same turned by half a turn, or mirrored in both axes. One or two stand for a material
  /// that looks the same turned by any angle.
  explicit MeasuredBrdf(BrdfMeasurement measurement);

  const std::vector<float>& phi() const { return phi_; }
  const std::vector<float>& theta() const { return theta_; }
  const SquareTable<float>& ndf() const { return ndf_; }
  const SquareTable<float>& sigma() const { return sigma_; }
  const SquareTable<float>& vndf() const { return vndf_.table(); }
  const SquareTable<float>& luminance() const { return luminance_.table(); }
  const SquareTable<Rgb>& reflected() const { return reflected_; }
  bool is_relative_to_facets() const { return is_relative_to_facets_; }

  bool is_anisotropic() const { return phi_.size() > 2; }
  /// 1, or 2 or 4 where a half or a quarter of the azimuths stands for all.
  int folds() const { return folds_; }
  /// In memory.
  std::size_t bytes() const;

  /// Of light from 45 degrees, about; in [0, 1].
  const Rgb& albedo() const { return albedo_; }
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi) const;
  BsdfSample sample(const Vec3& wo, Vec2 u) const;

 private:
  /// A direction to the viewer, in the part of the circle that was measured.
  struct Seen {
    Vec3 wo;
    float sign_x, sign_y;  ///< By which it was mirrored into it.
    SliceBlend blend;
    double turns;  ///< Its azimuth, where the square's y is relative to it; else 0.
  };
  Seen seen(const Vec3& wo) const;
  BsdfValue evaluate(const Seen& from, const Vec3& wi) const;
  Rgb mean_albedo() const;

  std::vector<float> phi_, theta_;
  SquareTable<float> ndf_, sigma_;
  SquareDensity vndf_, luminance_;
  SquareTable<Rgb> reflected_;
  bool is_relative_to_facets_;
  int folds_ = 1;  ///< So often the azimuths fit into the circle.
  Rgb albedo_;
};

}  // namespace twinray
