// SPDX-License-Identifier: Apache-2.0
// Private: samples of sphere lights (core/light_set.cpp) in lanes, compiled once for each instruction set. In
// double where the scalar code is, half of the lanes at a time.
#if defined(TWINRAY_WAVE_SPHERE_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_SPHERE_LIGHT_INL_H
#undef TWINRAY_WAVE_SPHERE_LIGHT_INL_H
#else
#define TWINRAY_WAVE_SPHERE_LIGHT_INL_H
#endif

#include "integrators/wave/double_lanes-inl.h"
#include "integrators/wave/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// visible_cone: 1 - cos of the half-angle; 0 from inside of the sphere and from its own surface.
HWY_ATTR HWY_INLINE HalfLanes visible_cone(const SphereLightRequest& light, HalfLanes distance_squared) {
  const DoubleTag tag;
  const DoubleLanes one = hn::Set(tag, 1), distance = hn::PromoteTo(tag, distance_squared);
  const DoubleLanes sin_squared = hn::Div(hn::Set(tag, light.squared_radius()), distance);
  const DoubleLanes cone = hn::Div(sin_squared, hn::Add(one, hn::Sqrt(hn::Sub(one, sin_squared))));
  const auto is_outside = hn::Gt(distance, hn::Set(tag, squared_reach(light.radius, light.offset)));
  return hn::DemoteTo(HalfTag(), hn::IfThenElseZero(is_outside, cone));
}
HWY_ATTR HWY_INLINE Lanes visible_cone(const SphereLightRequest& light, Lanes distance_squared) {
  const HalfTag half;
  return hn::Combine(FloatTag(), visible_cone(light, hn::UpperHalf(half, distance_squared)),
                     visible_cone(light, hn::LowerHalf(half, distance_squared)));
}

/// entry_normal.
HWY_ATTR HWY_INLINE HalfLanes3 entry_normal(const SphereLightRequest& light, const HalfLanes3& from,
                                            const HalfLanes3& direction) {
  const DoubleTag tag;
  const DoubleLanes3 center{hn::Set(tag, light.center.x), hn::Set(tag, light.center.y),
                            hn::Set(tag, light.center.z)};
  const DoubleLanes3 d = promote(direction), o = promote(from) - center;
  const DoubleLanes3 closest = o + d * hn::Div(hn::Neg(dot(o, d)), dot(d, d));
  const DoubleLanes room = hn::Sub(hn::Set(tag, light.squared_radius()), dot(closest, closest));
  const DoubleLanes h = hn::Sqrt(hn::IfThenElseZero(hn::Gt(room, hn::Zero(tag)), room));
  const DoubleLanes3 normal = closest - d * h;
  return demote(normal / hn::Sqrt(dot(normal, normal)));
}

HWY_ATTR void sample_sphere_light(const Surfaces& surfaces, const SphereLightRequest& light,
                                  LightSamples& samples, std::size_t size) {
  const Lanes3 center = splat(light.center.x, light.center.y, light.center.z);
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes3 from = load(surfaces.point.position, i);
    const Lanes3 axis = center - from;
    const Lanes squared = dot(axis, axis);
    const Lanes cone = visible_cone(light, squared);
    const Lanes3 local = direction_around_z(hn::Mul(load(samples.ux, i), cone), load(samples.uy, i));
    const Lanes3 direction = to_world(axis / hn::Sqrt(squared), local);
    const Lanes3 normal = combine(entry_normal(light, upper_half(from), upper_half(direction)),
                                  entry_normal(light, lower_half(from), lower_half(direction)));
    const Lanes3 position = center + normal * splat(light.radius);
    const LaneMask arrives = hn::And(is_positive_and_finite(squared), is_positive(cone));
    const Lanes pdf = hn::Div(splat(1), hn::Mul(splat(2 * pi), cone));
    store_arriving(arrives, direction, splat(light.radiance), pdf, samples, i);
    store_ray_to({position, normal, splat(light.offset)}, surfaces, samples, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
