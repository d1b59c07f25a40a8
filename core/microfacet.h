// SPDX-License-Identifier: Apache-2.0
// Rough surfaces as heights whose small facets are smooth mirrors or boundaries. What such a surface scatters
// depends on how its facets are oriented (D), how much of them a direction sees (G) and what one of them
// reflects (core/fresnel.h).
//
// Directions and facet normals are unit vectors with z along the surface's normal.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/vec.h"
#include "core/warp.h"

namespace twinray {

/// Below this alpha, as in pbrt, what facets scatter is too narrow for float, and looks like a smooth
/// surface.
inline constexpr float least_alpha = 1e-3f;

/// Two directions of which one is the mirror image of the other at a facet.
struct FacetReflection {
  float cosine = 1;  ///< Of each to the facet's normal.
  float value = 0;   ///< D G / (4 wo.z wi.z): f(wo, wi) of facets that reflect everything.
  float pdf = 0;     ///< Per solid angle, of wi, where wo is reflected at the normals that it sees.
};

/// How the ellipse of two alphas lies to a direction's azimuth.
struct Azimuth {
  float share = 0.5f;  ///< The alpha along the direction, over the sum of it and the alpha across it.
  float skew2 = 0;     ///< The square of how much slopes along and across go together: 0 along the axes, < 1.
};

/// Facets distributed as on an ellipsoid: GGX (Walter et al. 2007), which is Trowbridge and Reitz's (1975);
/// Smith's masking. Alphas along x and y, > 0; 1 is very rough.
class Ggx {
 public:
  Ggx(float alpha_x, float alpha_y) : x_(alpha_x), y_(alpha_y) {}
  explicit Ggx(float alpha) : Ggx(alpha, alpha) {}

  float alpha_x() const { return x_; }
  float alpha_y() const { return y_; }
  /// The root mean square of both: the alpha of facets without direction that lose about as much.
  float mean_alpha() const { return std::sqrt(0.5f * (x_ * x_ + y_ * y_)); }
  /// Of facets without direction that reflect about as much of light along w where Fresnel's equations
  /// decide: that along w at the horizon, mean_alpha() along the normal.
  float alpha_towards(const Vec3& w) const {
    const float x = x_ * w.x, y = y_ * w.y, z = mean_alpha() * w.z;
    return std::sqrt(x * x + y * y + z * z);
  }
  bool has_one_alpha() const { return x_ == y_; }
  /// That of w; of the normal, that of x.
  Azimuth azimuth(const Vec3& w) const {
    const float xx = x_ * w.x, yy = y_ * w.y, xy = x_ * w.y, yx = y_ * w.x;
    const float along2 = xx * xx + yy * yy, across2 = xy * xy + yx * yx, both2 = along2 + across2;
    if (!(both2 > 0)) return {x_ / (x_ + y_), 0};
    const float along = std::sqrt(along2), skew = 2 * (yx * yy - xx * xy) / both2;
    return {along / (along + std::sqrt(across2)), skew * skew};
  }

  /// The area of facets with the normal m, per solid angle and per area of the surface: the integral of
  /// D(m) m.z is 1. m.z >= 0.
  float density(const Vec3& m) const {
    const float x = m.x / x_, y = m.y / y_;
    const float ellipsoid = x * x + y * y + m.z * m.z;
    return 1 / (pi * x_ * y_ * ellipsoid * ellipsoid);
  }
  /// The area that w sees hidden, relative to what it sees (Smith's Lambda, Heitz 2014). w.z != 0.
  float lambda(const Vec3& w) const {
    const float x = x_ * w.x, y = y_ * w.y;
    const float slope2 = (x * x + y * y) / (w.z * w.z);
    // (sqrt(1 + s) - 1) / 2 without the loss of digits for small s.
    return 0.5f * slope2 / (1 + std::sqrt(1 + slope2));
  }
  /// The part of the facets' area towards w that is not hidden from w.
  float masking(const Vec3& w) const { return 1 / (1 + lambda(w)); }
  /// The part that neither of two directions, on one side or on two, has hidden: correlated by height, since
  /// high facets are seen from everywhere.
  float shadowing_masking(const Vec3& wo, const Vec3& wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }

  /// The density, per solid angle, of the normals that w (w.z > 0) sees: G1(w) max(0, w.m) D(m) / w.z.
  float visible_density(const Vec3& w, const Vec3& m) const {
    return masking(w) * std::max(0.0f, dot(w, m)) * density(m) / w.z;
  }
  /// A normal with that density, from u in the unit square: stretched to a half-sphere, the normals are half
  /// way between w and a uniform spherical cap (Dupuy and Benyoub, "Sampling Visible GGX Normals with
  /// Spherical Caps", 2023).
  Vec3 sample_visible(const Vec3& w, Vec2 u) const {
    const Vec3 stretched = normalize({x_ * w.x, y_ * w.y, w.z});
    const float z = (1 - u.y) * (1 + stretched.z) - stretched.z;
    const float r = std::sqrt(std::max(0.0f, (1 - z) * (1 + z)));
    const SinCos angle = sincos_turns(u.x);
    const Vec3 m{x_ * (r * angle.cos + stretched.x), y_ * (r * angle.sin + stretched.y),
                 std::max(0.0f, z + stretched.z)};
    const float length2 = length_squared(m);
    return length2 > 0 ? m / std::sqrt(length2) : Vec3{0, 0, 1};
  }
  /// How facets reflect wi to wo; both z > 0.
  FacetReflection reflection(const Vec3& wo, const Vec3& wi) const {
    const Vec3 m = normalize(wo + wi);
    const float facets = density(m), hidden_o = lambda(wo);
    return {.cosine = std::min(1.0f, dot(wo, m)),
            .value = facets * (1 / (1 + hidden_o + lambda(wi))) / (4 * wo.z * wi.z),
            // Turning m by an angle turns wi by twice that: dm = dwi / (4 wo.m), and wo.m cancels.
            .pdf = 1 / (1 + hidden_o) * facets / (4 * wo.z)};
  }

 private:
  float x_, y_;
};

/// The mirror image of w at the facet normal m: both point away from the facet. Unit, as far as w and m are.
constexpr Vec3 reflected(const Vec3& w, const Vec3& m) { return 2 * dot(w, m) * m - w; }

}  // namespace twinray
