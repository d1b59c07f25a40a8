// SPDX-License-Identifier: Apache-2.0
// Private: points of triangles (core/surface.h) and what scattering needs of them (integrators/interaction.h)
// in lanes, compiled once for each instruction set.
#if defined(TWINRAY_WAVE_SURFACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_SURFACES_INL_H
#undef TWINRAY_WAVE_SURFACES_INL_H
#else
#define TWINRAY_WAVE_SURFACES_INL_H
#endif

#include <bit>

#include "core/offset.h"
#include "core/triangle_weights.h"
#include "core/warp.h"
#include "integrators/wave/double_lanes-inl.h"
#include "integrators/wave/wave.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// AreaVector::normal.
HWY_ATTR HWY_INLINE HalfLanes3 triangle_normal(const HalfLanes3& a, const HalfLanes3& b,
                                               const HalfLanes3& c) {
  const DoubleLanes3 from = promote(a), u = promote(b) - from, v = promote(c) - from;
  const DoubleLanes3 area{hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)),
                          hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
                          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
  return demote(area * hn::Div(hn::Set(DoubleTag(), 1), hn::Sqrt(dot(area, area))));
}

HWY_ATTR HWY_INLINE Lanes max_abs(const Lanes3& a) {
  return hn::Max(hn::Abs(a.x), hn::Max(hn::Abs(a.y), hn::Abs(a.z)));
}

HWY_ATTR void find_facets(const TrianglePoints& triangles, Points& points, std::size_t size) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes3 a = load(triangles.a, i), b = load(triangles.b, i), c = load(triangles.c, i);
    store(combine(triangle_normal(upper_half(a), upper_half(b), upper_half(c)),
                  triangle_normal(lower_half(a), lower_half(b), lower_half(c))),
          points.normal, i);
    const Lanes coordinate = hn::Max(max_abs(a), hn::Max(max_abs(b), max_abs(c)));
    const Lanes edge = hn::Max(max_abs(b - a), hn::Max(max_abs(c - a), max_abs(c - b)));
    store(hn::Mul(splat(ten_roundings), hn::Add(coordinate, edge)), points.offset, i);
  }
}

struct WeightLanes {
  Lanes a, b, c;
};

/// keep_off_edges: few points are that close to an edge, so they are moved one by one.
HWY_ATTR HWY_INLINE WeightLanes keep_off_edges(const TrianglePoints& triangle, const Floats& offset,
                                               std::size_t i, const WeightLanes& weights) {
  const Lanes least = hn::Min(weights.a, hn::Min(weights.b, weights.c));
  std::uint32_t close = bits_of(hn::Lt(least, splat(edge_weight)));
  if (close == 0) return weights;
  HWY_ALIGN float a[lane_count], b[lane_count], c[lane_count];
  hn::Store(weights.a, FloatTag(), a);
  hn::Store(weights.b, FloatTag(), b);
  hn::Store(weights.c, FloatTag(), c);
  for (; close != 0; close &= close - 1) {
    const std::size_t lane = std::size_t(std::countr_zero(close)), at = i + lane;
    const TriangleWeights moved = twinray::keep_off_edges(
        triangle.a.at(at), triangle.b.at(at), triangle.c.at(at), {a[lane], b[lane], c[lane]}, offset[at]);
    a[lane] = moved.a;
    b[lane] = moved.b;
    c[lane] = moved.c;
  }
  return {hn::Load(FloatTag(), a), hn::Load(FloatTag(), b), hn::Load(FloatTag(), c)};
}

/// Interpolates between three numbers, and stays between them. As in core/lanes.h, the second operand is the
/// least, or the largest, of equal ones.
HWY_ATTR HWY_INLINE Lanes interpolate(Lanes a, Lanes b, Lanes c, const WeightLanes& weights) {
  const auto min = [](Lanes p, Lanes q) HWY_ATTR { return select(hn::Lt(p, q), p, q); };
  const auto max = [](Lanes p, Lanes q) HWY_ATTR { return select(hn::Gt(p, q), p, q); };
  const Lanes p = hn::Add(hn::Add(hn::Mul(a, weights.a), hn::Mul(b, weights.b)), hn::Mul(c, weights.c));
  return min(max(max(c, b), a), max(min(min(c, b), a), p));
}

/// The positions of points on triangles.
HWY_ATTR HWY_INLINE Lanes3 position_of(const TrianglePoints& triangle, const Floats& offset, std::size_t i,
                                       const WeightLanes& given) {
  const WeightLanes weights = keep_off_edges(triangle, offset, i, given);
  const Lanes3 a = load(triangle.a, i), b = load(triangle.b, i), c = load(triangle.c, i);
  return {interpolate(a.x, b.x, c.x, weights), interpolate(a.y, b.y, c.y, weights),
          interpolate(a.z, b.z, c.z, weights)};
}

/// The weights of all three corners, from those of the second and the third.
HWY_ATTR HWY_INLINE WeightLanes weights_of(Lanes u, Lanes v) {
  return {hn::Sub(hn::Sub(splat(1), u), v), u, v};
}

HWY_ATTR void find_points(Surfaces& surfaces, std::size_t size) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    const WeightLanes weights = weights_of(load(surfaces.triangle.u, i), load(surfaces.triangle.v, i));
    store(position_of(surfaces.triangle, surfaces.point.offset, i, weights), surfaces.point.position, i);
    const Lanes3 mixture = load(surfaces.normal_a, i) * weights.a + load(surfaces.normal_b, i) * weights.b +
                           load(surfaces.normal_c, i) * weights.c;
    const Lanes squared = dot(mixture, mixture);
    const LaneMask has_length = hn::And(hn::Gt(squared, splat(1e-12f)), is_positive_and_finite(squared));
    store(select(has_length, mixture / hn::Sqrt(squared), load(surfaces.point.normal, i)), surfaces.shading,
          i);
  }
}

HWY_ATTR void find_interactions(const Paths& paths, Surfaces& surfaces) {
  const Lanes zero = hn::Zero(FloatTag());
  for (std::size_t i = 0; i < paths.size; i += lane_count) {
    const Lanes3 direction = load(paths.direction, i);
    const Lanes3 wo = -(direction / hn::Sqrt(dot(direction, direction)));
    const Lanes3 normal = load(surfaces.point.normal, i);
    const LaneMask looks_away = hn::Lt(dot(normal, wo), zero);
    const Lanes3 facing_normal = select(looks_away, -normal, normal);
    const Lanes3 given = load(surfaces.shading, i);
    const Lanes3 turned = select(hn::Lt(dot(given, facing_normal), zero), -given, given);
    const Lanes3 shading = select(is_positive(dot(turned, wo)), turned, facing_normal);
    store(shading, surfaces.shading, i);
    store(select(looks_away, splat(-1), splat(1)), surfaces.facing, i);
    store(dot(wo, shading), surfaces.wo_z, i);
  }
}

/// Where rays along a direction leave the surfaces: leave_surface.
HWY_ATTR HWY_INLINE Lanes3 leave_surface(const Lanes3& position, const Lanes3& normal, Lanes offset,
                                         const Lanes3& direction) {
  const Lanes side = select(hn::Lt(dot(normal, direction), hn::Zero(FloatTag())), hn::Neg(offset), offset);
  return position + normal * side;
}
HWY_ATTR HWY_INLINE Lanes3 leave_surface(const Points& points, std::size_t i, const Lanes3& direction) {
  return leave_surface(load(points.position, i), load(points.normal, i), load(points.offset, i), direction);
}

/// Whether directions lie on one side of both normals.
HWY_ATTR HWY_INLINE LaneMask is_consistent(const Surfaces& surfaces, std::size_t i, const Lanes3& wi) {
  const Lanes geometric = hn::Mul(load(surfaces.facing, i), dot(load(surfaces.point.normal, i), wi));
  const Lanes shading = dot(load(surfaces.shading, i), wi);
  return hn::Not(hn::Xor(is_positive(geometric), is_positive(shading)));
}

/// The reflectance over pi: a Lambert surface's BSDF.
HWY_ATTR HWY_INLINE Lanes3 bsdf(const Surfaces& surfaces, std::size_t i) {
  return load(surfaces.reflectance, i) * splat(1 / pi);
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
