// SPDX-License-Identifier: Apache-2.0
// The exact judge: what a ray truly hits, decided in exact arithmetic.
//
// Rays, triangles and spheres are given in float, so each question about them is the sign of a polynomial in
// rational numbers. It is answered by a filter in double and, where that is not enough, by integers of any
// length (check/exact.h). Nothing is shared with the tests of core/, so that an error there is seen here.
// Accepted is any ray with a finite origin, a finite direction that is not zero, a finite t_min and a finite
// or positive infinite t_max, whatever their size. Where NaN or another infinity stands, Error is thrown.
#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry.h"
#include "core/ray.h"

namespace twinray {

/// A number known to lie within `error` (>= 0) of `value`.
struct Estimate {
  double value = 0, error = 0;
};

/// Where the line of a ray (all t, not only the ray's interval) passes a closed triangle.
enum class LinePosition {
  inside,     ///< Through the interior.
  on_edge,    ///< Through an edge, but no vertex.
  on_vertex,  ///< Through a vertex.
  outside,    ///< It crosses the triangle's plane elsewhere.
  edge_on     ///< It is parallel to the plane or lies in it, or the triangle has no area.
};

/// Where a parameter t lies with respect to the interval [t_min, t_max]. Where t_min = t_max, at_min wins.
enum class IntervalPosition { below, at_min, within, at_max, above };

/// The exact relation of a ray and a triangle.
struct TriangleJudgement {
  LinePosition position = LinePosition::edge_on;
  IntervalPosition interval = IntervalPosition::within;  ///< Of the crossing with the plane, exact.
  Estimate t;                     ///< The parameter of that crossing; its relative error is below 2^-40.
  double weights[3] = {0, 0, 0};  ///< Of the three vertices at the crossing, to about 2^-40; may be negative.
  /// How far the line passes from the nearest of the lines through the edges, perpendicular to the ray:
  /// positive inside, negative outside (there, the largest distance by which it is beyond one of them). To
  /// about 2^-30 of itself.
  double edge_distance = 0;
  double scale = 0;   ///< The largest component of vertex - origin: the size on which float tests round.
  double cosine = 0;  ///< |cos| of the angle between ray and normal, to about 2^-30; small where it grazes.
  /// |d . n| / (|d| L^2), with n the cross product of two edges and L the longest edge, to about 2^-30: small
  /// for slivers and grazing rays. Float tests lose the reciprocal of it in t and the weights.
  double conditioning = 0;

  // For an edge-on triangle only position and scale have a meaning.

  /// edge_distance in units of 2^-24 scale: within about 10 of zero a float test may decide either way.
  double edge_margin_ulps() const { return edge_distance / (scale * 0x1p-24); }
  /// Whether the line passes through the closed triangle.
  bool crosses() const { return position != LinePosition::outside && position != LinePosition::edge_on; }
  /// Whether the ray does within its closed interval.
  bool hits() const {
    return crosses() && interval != IntervalPosition::below && interval != IntervalPosition::above;
  }
};

TriangleJudgement judge_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// The exact relation of a ray and a sphere.
struct SphereJudgement {
  int roots = 0;  ///< How often the line intersects the surface: 0, 1 (a tangent) or 2; 0 without a radius.
  Estimate t[2];  ///< The near root and the far one (a tangent has its one root twice).
  IntervalPosition interval[2] = {IntervalPosition::above, IntervalPosition::above};
  double depth = 0;  ///< Radius minus the distance of line and centre: negative for a miss, 0 for a tangent.
  double scale = 0;  ///< The largest component of centre - origin, plus the radius.

  /// depth in units of 2^-24 scale.
  double margin_ulps() const { return depth / (scale * 0x1p-24); }
  /// Whether the ray intersects the surface at root 0 or 1 within its closed interval.
  bool hits(int root) const {
    return roots > 0 && interval[root] != IntervalPosition::below &&
           interval[root] != IntervalPosition::above;
  }
};

SphereJudgement judge_sphere(const Ray& ray, const Sphere& sphere);

/// A ray in the space of an instance.
struct OwnRay {
  Ray ray;           ///< Its origin and direction rounded to float.
  int exponent = 0;  ///< Its t is that of the given ray times 2 to the power of this.
  std::uint32_t instance = no_instance;
};

/// Without an instance the ray itself. A direction far from 1 is scaled, so that it stays finite.
OwnRay ray_in(const Geometry& geometry, const Ray& ray, std::uint32_t instance);

/// A primitive that the exact ray hits within its closed interval.
struct JudgedHit {
  std::uint32_t mesh = 0, primitive = 0;
  Estimate t;  ///< The least such parameter of this primitive.
  std::uint32_t instance = no_instance;
};

/// All of them, every primitive tested, ordered by t.value, then instance, mesh and primitive as they lie in
/// the geometry. Triangles seen edge-on are not hit. In an instance the ray is judged that is rounded into
/// its space (ray_in()).
std::vector<JudgedHit> judge_all(const Geometry& geometry, const Ray& ray);
/// Those of them that may be the first: no other one is certainly nearer. Empty for a true miss; more than
/// one where the ray hits an edge, a vertex or coincident shapes.
std::vector<JudgedHit> judge_closest(const Geometry& geometry, const Ray& ray);

}  // namespace twinray
