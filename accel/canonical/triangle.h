// SPDX-License-Identifier: Apache-2.0
// Private: the canonical ray-triangle test, after Woop, Benthin and Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013.
//
// Each vertex is translated to the ray's origin and sheared so that the ray runs along +z: a function of ray
// and vertex alone, so triangles that share a vertex see it at the same place. The three edge functions then
// decide. We depart from the paper in two points. In float they only reject, and only where rounding cannot
// have changed a sign; everything else is computed again in double, which holds the products of two floats
// exactly. So the signs are those of the rounded vertices, exactly, and no ray slips through an edge or a
// vertex. And t, u, v come from the double ones: the point of these weights lies within 9 u (u = 2^-24) of
// the largest component of vertex - origin beside the ray, where float weights of a sliver are lost in
// rounding.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/canonical/slab.h"
#include "core/geometry.h"

namespace twinray {

/// t is the scaled ray's parameter; u and v are the weights of the second and third vertex.
struct ShapeHit {
  float t, u, v;
};

/// A vertex in the ray's frame: the ray is the z axis, z counts in t.
struct ShearedVertex {
  float x, y, z;
};

inline ShearedVertex shear(const CheckedRay& ray, const Vec3& p) {
  const float z = p[ray.axes[2]] - ray.turned_origin[2];
  return {(p[ray.axes[0]] - ray.turned_origin[0]) - ray.shear[0] * z,
          (p[ray.axes[1]] - ray.turned_origin[1]) - ray.shear[1] * z, ray.shear[2] * z};
}

/// An edge function below this times the largest |x| times the largest |y| may have the wrong sign: the
/// rounding of two products and a difference is at most 4 u of the larger product (u = 2^-24), doubled for
/// safety.
inline constexpr float edge_margin = 0x1p-21f;
/// What underflow may add to that.
inline constexpr float edge_underflow = std::numeric_limits<float>::min();

/// The weights of the three vertices before division by their sum; Real is float (to reject) or double.
template <typename Real>
struct EdgeFunctions {
  Real a, b, c;

  EdgeFunctions(const ShearedVertex& p, const ShearedVertex& q, const ShearedVertex& r)
      : a(Real(r.x) * Real(q.y) - Real(r.y) * Real(q.x)),
        b(Real(p.x) * Real(r.y) - Real(p.y) * Real(r.x)),
        c(Real(q.x) * Real(p.y) - Real(q.y) * Real(p.x)) {}
  Real least() const { return std::min(a, std::min(b, c)); }
  Real largest() const { return std::max(a, std::max(b, c)); }
  /// False outside of the triangle, and for a triangle seen edge-on.
  bool interpolate(const ShearedVertex& p, const ShearedVertex& q, const ShearedVertex& r,
                   ShapeHit& hit) const {
    const Real determinant = a + b + c;
    if ((least() < 0 && largest() > 0) || determinant == 0) return false;
    hit.u = float(b / determinant);
    hit.v = float(c / determinant);
    hit.t = float((a * p.z + b * q.z + c * r.z) / determinant);
    return true;
  }
};

/// The rounding error that a float edge function of these vertices can have.
inline float edge_error(const ShearedVertex& p, const ShearedVertex& q, const ShearedVertex& r) {
  const float x = std::max(std::fabs(p.x), std::max(std::fabs(q.x), std::fabs(r.x)));
  const float y = std::max(std::fabs(p.y), std::max(std::fabs(q.y), std::fabs(r.y)));
  return edge_margin * (x * y) + edge_underflow;
}

/// Whether the float edge functions leave no doubt that the ray passes beside the triangle.
inline bool is_beside(const ShearedVertex& p, const ShearedVertex& q, const ShearedVertex& r) {
  const EdgeFunctions<float> edges(p, q, r);
  const float error = edge_error(p, q, r);
  return edges.least() < -error && edges.largest() > error;
}

/// The hit with a triangle that has an area and is not beside the ray, in [ray.t_min, t_max]; it remains to
/// ask is_within_box().
inline bool intersect_sheared(const CheckedRay& ray, const ShearedVertex& p, const ShearedVertex& q,
                              const ShearedVertex& r, float t_max, ShapeHit& hit) {
  return EdgeFunctions<double>(p, q, r).interpolate(p, q, r, hit) && hit.t >= ray.t_min && hit.t <= t_max;
}

/// The hit of a ray with the triangle a, b, c in the closed interval [ray.t_min, t_max]; false for none.
inline bool intersect_triangle(const CheckedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               float t_max, ShapeHit& hit) {
  const ShearedVertex p = shear(ray, a), q = shear(ray, b), r = shear(ray, c);
  // Rounding gives a degenerate triangle some area in the ray's frame; it is never hit all the same.
  return !is_beside(p, q, r) && has_area(a, b, c) && intersect_sheared(ray, p, q, r, t_max, hit) &&
         is_within_box(ray, triangle_bounds(a, b, c), hit.t);
}

}  // namespace twinray
