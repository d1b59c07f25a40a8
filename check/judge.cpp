// SPDX-License-Identifier: Apache-2.0
#include "check/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/exact.h"

namespace twinray {
namespace {

// The relative errors below which a filtered number is good enough to report: of t and the weights, and of
// the squared lengths that measures of distance are divided by.
constexpr double report_error = 0x1p-40, length_error = 0x1p-30;

Bounded bounded(const Bounded& a) { return a; }
Bounded bounded(const Exact& a) { return a.bounded(); }
bool is_precise(const Bounded& a, double relative_error = report_error) {
  return a.error <= std::fabs(a.value) * relative_error;
}
Estimate estimate(const Bounded& a) { return {a.value, a.error}; }

template <typename Real>
struct Vector {
  Real x, y, z;
};

template <typename Real>
Vector<Real> difference(const Vec3& a, const Vec3& b) {
  return {Real(a.x) - Real(b.x), Real(a.y) - Real(b.y), Real(a.z) - Real(b.z)};
}
template <typename Real>
Vector<Real> vector(const Vec3& a) {
  return {Real(a.x), Real(a.y), Real(a.z)};
}
template <typename Real>
Real inner(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename Real>
Vector<Real> outer(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename Real>
Real squared(const Vector<Real>& a) {
  return inner(a, a);
}
double largest(const Vector<Bounded>& a) {
  return std::max(std::fabs(a.x.value), std::max(std::fabs(a.y.value), std::fabs(a.z.value)));
}

/// Whether no t is too large for the ray's interval.
bool is_endless(const Ray& ray) { return ray.t_max == std::numeric_limits<float>::infinity(); }

IntervalPosition position_in_interval(int beyond_min, int beyond_max) {
  if (beyond_min <= 0) return beyond_min < 0 ? IntervalPosition::below : IntervalPosition::at_min;
  if (beyond_max >= 0) return beyond_max > 0 ? IntervalPosition::above : IntervalPosition::at_max;
  return IntervalPosition::within;
}

/// The polynomials that decide about a triangle. With a, b, c relative to the origin: the volumes d . (b x
/// c), d . (c x a), d . (a x b), which are the weights times their sum; and t = height / slope, with n the
/// normal.
template <typename Real>
struct TriangleSigns {
  Real volume[3], slope, height, beyond_min, beyond_max;
  Real edge_squared[3], normal_squared;  ///< |d x edge|^2 and |n|^2.

  TriangleSigns(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto d = vector<Real>(ray.direction);
    const auto p = difference<Real>(a, ray.origin), q = difference<Real>(b, ray.origin),
               r = difference<Real>(c, ray.origin);
    const auto n = outer(difference<Real>(b, a), difference<Real>(c, a));
    volume[0] = inner(d, outer(q, r));
    volume[1] = inner(d, outer(r, p));
    volume[2] = inner(d, outer(p, q));
    slope = inner(d, n);
    height = inner(p, n);
    beyond_min = height - Real(ray.t_min) * slope;
    beyond_max = is_endless(ray) ? -slope : height - Real(ray.t_max) * slope;
    edge_squared[0] = squared(outer(d, difference<Real>(c, b)));
    edge_squared[1] = squared(outer(d, difference<Real>(a, c)));
    edge_squared[2] = squared(outer(d, difference<Real>(b, a)));
    normal_squared = squared(n);
  }
  /// Of Bounded: whether the signs are certain and the values precise.
  bool suffice() const {
    for (int i = 0; i < 3; ++i)
      if (!volume[i].has_sign() || !is_precise(volume[i]) || !is_precise(edge_squared[i], length_error))
        return false;
    return slope.has_sign() && beyond_min.has_sign() && beyond_max.has_sign() && is_precise(slope) &&
           is_precise(height) && is_precise(normal_squared, length_error);
  }
};

template <typename Real>
LinePosition line_position(const TriangleSigns<Real>& signs) {
  const int facing = signs.slope.sign();
  if (facing == 0) return LinePosition::edge_on;
  int zeros = 0;
  for (const Real& volume : signs.volume) {
    if (volume.sign() * facing < 0) return LinePosition::outside;
    zeros += volume.sign() == 0;
  }
  return zeros == 0 ? LinePosition::inside : zeros == 1 ? LinePosition::on_edge : LinePosition::on_vertex;
}

template <typename Real>
TriangleJudgement triangle_judgement(const TriangleSigns<Real>& signs, const Ray& ray, const Vec3& a,
                                     const Vec3& b, const Vec3& c) {
  TriangleJudgement judgement;
  judgement.position = line_position(signs);
  for (const Vec3& p : {a, b, c})
    judgement.scale = std::max(judgement.scale, largest(difference<Bounded>(p, ray.origin)));
  if (judgement.position == LinePosition::edge_on) return judgement;
  const int facing = signs.slope.sign();
  judgement.interval =
      position_in_interval(facing * signs.beyond_min.sign(), facing * signs.beyond_max.sign());
  const Bounded slope = bounded(signs.slope);
  judgement.t = estimate(bounded(signs.height) / slope);
  judgement.edge_distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double volume = bounded(signs.volume[i]).value;
    judgement.weights[i] = volume / slope.value;
    judgement.edge_distance =
        std::min(judgement.edge_distance, facing * volume / std::sqrt(bounded(signs.edge_squared[i]).value));
  }
  const Bounded direction_squared = squared(vector<Bounded>(ray.direction));
  judgement.cosine =
      std::fabs(slope.value) / std::sqrt(bounded(signs.normal_squared).value * direction_squared.value);
  double longest_squared = 0;
  for (const auto& edge : {difference<Bounded>(b, a), difference<Bounded>(c, b), difference<Bounded>(a, c)})
    longest_squared = std::max(longest_squared, squared(edge).value);
  judgement.conditioning = std::fabs(slope.value) / std::sqrt(direction_squared.value) / longest_squared;
  return judgement;
}

/// The polynomials that decide about a sphere: the points of the line are at |o + t d - c|^2 - r^2 =
/// a t^2 + 2 half_b t + c, the quarter of whose discriminant is a r^2 - |d x (o - c)|^2.
template <typename Real>
struct SphereSigns {
  Real a, half_b, c, discriminant, lateral;
  Real at_min, slope_at_min, at_max, slope_at_max;

  SphereSigns(const Ray& ray, const Sphere& sphere) {
    const auto d = vector<Real>(ray.direction), o = difference<Real>(ray.origin, sphere.center);
    const auto moment = outer(d, o);
    const Real squared_radius = Real(sphere.radius) * Real(sphere.radius);
    a = inner(d, d);
    half_b = inner(d, o);
    c = inner(o, o) - squared_radius;
    lateral = inner(moment, moment);
    discriminant = a * squared_radius - lateral;
    evaluate(ray.t_min, at_min, slope_at_min);
    if (!is_endless(ray)) evaluate(ray.t_max, at_max, slope_at_max);
  }
  void evaluate(float t, Real& value, Real& slope) const {
    slope = a * Real(t) + half_b;
    value = (slope + half_b) * Real(t) + c;
  }
  /// Of Bounded: whether the signs are certain and the values precise.
  bool suffice() const {
    return discriminant.has_sign() && at_min.has_sign() && slope_at_min.has_sign() && at_max.has_sign() &&
           slope_at_max.has_sign() && is_precise(half_b) && is_precise(c) && is_precise(discriminant) &&
           is_precise(lateral);
  }
};

/// The sign of root - t, given those of the quadratic and its slope at t; root 0 is the near one.
int sign_beyond(int root, int value, int slope) {
  const int side = root == 0 ? -1 : 1;  // of the slope, at the root and on its outer side
  if (value == 0 && slope * side >= 0) return 0;
  const bool is_outer = value > 0 && slope * side > 0;
  return is_outer ? -side : side;
}

template <typename Real>
void set_roots(SphereJudgement& judgement, const SphereSigns<Real>& signs) {
  const Bounded root = square_root(bounded(signs.discriminant)), half_b = bounded(signs.half_b);
  const Bounded a = bounded(signs.a), c = bounded(signs.c);
  if (half_b.value > 0) {
    const Bounded q = -(half_b + root);
    judgement.t[0] = estimate(q / a);
    judgement.t[1] = estimate(c / q);
  } else if (root.value - half_b.value > 0) {
    const Bounded q = root - half_b;
    judgement.t[0] = estimate(c / q);
    judgement.t[1] = estimate(q / a);
  }
}

template <typename Real>
SphereJudgement sphere_judgement(const SphereSigns<Real>& signs, const Ray& ray, const Sphere& sphere) {
  SphereJudgement judgement;
  judgement.scale = largest(difference<Bounded>(sphere.center, ray.origin)) + sphere.radius;
  const Bounded a = bounded(signs.a), discriminant = bounded(signs.discriminant);
  const double distance = std::sqrt(bounded(signs.lateral).value / a.value);
  judgement.depth = discriminant.value / a.value / (sphere.radius + distance);
  judgement.roots = discriminant.sign() + 1;
  if (judgement.roots == 0) return judgement;
  set_roots(judgement, signs);
  for (int i = 0; i < 2; ++i) {
    const int beyond_min = sign_beyond(i, signs.at_min.sign(), signs.slope_at_min.sign());
    const int beyond_max =
        is_endless(ray) ? -1 : sign_beyond(i, signs.at_max.sign(), signs.slope_at_max.sign());
    judgement.interval[i] = position_in_interval(beyond_min, beyond_max);
  }
  return judgement;
}

/// `found`: who says so, but for the primitive.
void judge_mesh(const Mesh& mesh, JudgedHit found, const Ray& ray, std::vector<JudgedHit>& hits) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const auto judgement = judge_triangle(ray, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    if (!judgement.hits()) continue;
    found.primitive = i;
    found.t = judgement.t;
    hits.push_back(found);
  }
}

void judge_spheres(const SphereSet& set, JudgedHit found, const Ray& ray, std::vector<JudgedHit>& hits) {
  for (std::uint32_t i = 0; i < set.spheres.size(); ++i) {
    const auto judgement = judge_sphere(ray, set.spheres[i]);
    for (const int root : {0, 1}) {
      if (!judgement.hits(root)) continue;
      found.primitive = i;
      found.t = judgement.t[root];
      hits.push_back(found);
      break;
    }
  }
}

void judge_shapes(const Geometry& geometry, ShapeRange shapes, const OwnRay& own,
                  std::vector<JudgedHit>& hits) {
  const std::size_t before = hits.size();
  for (std::uint32_t i = shapes.first; i < shapes.end(); ++i) {
    const JudgedHit found{.mesh = i, .instance = own.instance};
    if (const Mesh* mesh = geometry.mesh(i))
      judge_mesh(*mesh, found, own.ray, hits);
    else
      judge_spheres(*geometry.sphere_set(i), found, own.ray, hits);
  }
  for (std::size_t i = before; i < hits.size(); ++i)
    hits[i].t = {std::ldexp(hits[i].t.value, -own.exponent), std::ldexp(hits[i].t.error, -own.exponent)};
}

}  // namespace

OwnRay ray_in(const Geometry& geometry, const Ray& ray, std::uint32_t instance) {
  constexpr int most = 60;
  if (instance == no_instance) return {ray};
  const Transform& to_object = geometry.placed()[instance].to_object;
  const int exponent = std::ilogb(max_abs(ray.direction));
  const int own = std::abs(exponent) > most ? exponent : 0;
  Vec3 direction = ray.direction;
  for (int axis = 0; axis < 3; ++axis) direction[axis] = std::ldexp(direction[axis], -own);
  const float t_min = std::ldexp(ray.t_min, own);
  return {{.origin = to_object.point(ray.origin),
           .direction = to_object.vector(direction),
           .t_min = std::min(t_min, std::numeric_limits<float>::max()),
           .t_max = std::ldexp(ray.t_max, own)},
          own,
          instance};
}

TriangleJudgement judge_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const TriangleSigns<Bounded> filter(ray, a, b, c);
  if (filter.suffice()) return triangle_judgement(filter, ray, a, b, c);
  return triangle_judgement(TriangleSigns<Exact>(ray, a, b, c), ray, a, b, c);
}

SphereJudgement judge_sphere(const Ray& ray, const Sphere& sphere) {
  if (!(sphere.radius > 0)) return {};
  const SphereSigns<Bounded> filter(ray, sphere);
  if (filter.suffice()) return sphere_judgement(filter, ray, sphere);
  return sphere_judgement(SphereSigns<Exact>(ray, sphere), ray, sphere);
}

std::vector<JudgedHit> judge_all(const Geometry& geometry, const Ray& ray) {
  std::vector<JudgedHit> hits;
  judge_shapes(geometry, geometry.direct_shapes(), {ray}, hits);
  for (std::uint32_t i = 0; i < geometry.instances().size(); ++i)
    judge_shapes(geometry, geometry.prototypes()[geometry.instances()[i].prototype], ray_in(geometry, ray, i),
                 hits);
  std::stable_sort(hits.begin(), hits.end(),
                   [](const JudgedHit& a, const JudgedHit& b) { return a.t.value < b.t.value; });
  return hits;
}

std::vector<JudgedHit> judge_closest(const Geometry& geometry, const Ray& ray) {
  std::vector<JudgedHit> hits = judge_all(geometry, ray);
  double nearest = std::numeric_limits<double>::infinity();
  for (const JudgedHit& hit : hits) nearest = std::min(nearest, hit.t.value + hit.t.error);
  std::erase_if(hits, [&](const JudgedHit& hit) { return hit.t.value - hit.t.error > nearest; });
  return hits;
}

}  // namespace twinray
