// SPDX-License-Identifier: Apache-2.0
// Why two engines may answer differently: every class is proved for the very ray by the exact judge.
//
// An answer is defensible where rounding of a known size could have made it out of the truth: its shape is
// one that the exact ray hits, or passes within that size; and the ray clearly hits no shape in front of it
// (or, for a miss, no shape at all). Two answers that differ are explained where both are defensible; the
// class says what made the second one possible.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "check/answer.h"
#include "check/judge.h"

namespace twinray {

enum class Difference {
  identical,     ///< Equal bits.
  rounding,      ///< The same shape; t, u and v are those of the exact hit within rounding_ulps.
  tie,           ///< The ray hits both shapes, with parameters within rounding_ulps of each other.
  overlap,       ///< The same, where both hits are clear and lie in one plane.
  edge,          ///< The ray passes within rounding_ulps of an edge, vertex or outline of the disputed shape.
  grazing,       ///< |cos| < grazing_cosine at the disputed shape.
  interval_end,  ///< The disputed hit lies within rounding_ulps of t_min or t_max (or the largest float).
  tiny,       ///< The disputed shape is shorter than rounding_ulps: from so far no float test sees its form.
  cut_out,    ///< Of a shape with holes, where u and v within that rounding lie both beside and in one.
  underflow,  ///< As rounding but for u and v: 2 |d . n| < smallest_divisor, n the product of two edges.
  unexplained
};
inline constexpr std::size_t difference_count = 11;

/// "identical", "interval end", ...
std::string difference_name(Difference difference);

/// The rounding that an engine of float arithmetic is allowed. An ulp of a distance is 2^-24 of the largest
/// component of vertex - origin (of an instance, of that or of what its transform rounds); one of t or a
/// weight is what that amounts to in a quotient whose divisor has
/// lost digits (TriangleJudgement::conditioning).
inline constexpr double rounding_ulps = 64;
inline constexpr double grazing_cosine = 1e-4;
/// Embree's own triangles have u = v = 0 where they would divide by less.
inline constexpr double smallest_divisor = 1e-18;

struct CheckedRay;
struct SceneBvh;

/// What the exact ray does with one primitive, seen with that allowance.
struct Testimony {
  enum class Standing { edge, grazing, interval_end, tiny, cut_out, firm };

  std::uint32_t mesh = 0, primitive = 0, instance = no_instance;
  Standing standing = Standing::firm;  ///< Why a test may miss it; firm: it may not.
  bool is_met = false;                 ///< By the exact ray, within its closed interval.
  double t = 0, t_ulp = 0;  ///< t is NaN, any, for tiny triangles, those seen edge-on, and outlines.
  double weights[3] = {0, 0, 0}, weight_ulp = 0;  ///< Of a triangle's vertices.
  double divisor = 0;  ///< 2 |d . n| of a triangle, d as engines take it (accel/canonical/checked_ray.h).
};

/// Judges answers about one geometry. Safe from any thread.
class Oracle {
 public:
  explicit Oracle(std::shared_ptr<const Geometry> geometry);
  ~Oracle();

  /// The class of two answers. Symmetrical. An invalid ray must miss: what differs there is unexplained.
  Difference classify(const Ray& ray, const Answer& a, const Answer& b) const;

  /// All primitives that an engine may report for this ray, in no particular order; a sphere at most twice,
  /// once for each root; where a shape has holes, none within them. Primitives whose padded boxes the ray
  /// misses are left out unseen.
  std::vector<Testimony> testimonies(const Ray& ray) const;

 private:
  /// Calls `visit` for the blocks that the ray may hit, and their instances.
  template <typename Visit>
  void visit_blocks(const CheckedRay& ray, const Visit& visit) const;
  std::vector<Testimony> firm_testimonies(const Ray& ray, float t_max) const;
  Difference classify_same_shape(const Ray& ray, const Hit& a, const Hit& b) const;
  Difference classify_without_claims(const Ray& ray) const;
  bool are_coplanar(const Testimony& a, const Testimony& b) const;

  std::shared_ptr<const Geometry> geometry_;
  std::unique_ptr<const SceneBvh> tree_;
};

}  // namespace twinray
