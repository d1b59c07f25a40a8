// SPDX-License-Identifier: Apache-2.0
// Private: direct light in lanes, compiled once for each instruction set: samples of mesh lights and the
// hemisphere, what surfaces scatter of them, and their sum.
#if defined(TWINRAY_WAVE_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_LIGHT_INL_H
#undef TWINRAY_WAVE_LIGHT_INL_H
#else
#define TWINRAY_WAVE_LIGHT_INL_H
#endif

#include "integrators/wave/requests.h"
#include "integrators/wave/surfaces-inl.h"
#include "integrators/wave/warp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

/// Density per solid angle of points chosen with density 1 / area; in double, since areas may be tiny.
HWY_ATTR HWY_INLINE HalfLanes area_to_solid_angle(DoubleLanes area, HalfLanes distance_squared,
                                                  HalfLanes cosine) {
  const auto projected = hn::Mul(hn::PromoteTo(DoubleTag(), hn::Abs(cosine)), area);
  return hn::DemoteTo(HalfTag(), hn::Div(hn::PromoteTo(DoubleTag(), distance_squared), projected));
}
HWY_ATTR HWY_INLINE Lanes area_to_solid_angle(const DoubleHalves& area, Lanes distance_squared,
                                              Lanes cosine) {
  const HalfTag half;
  return hn::Combine(
      FloatTag(),
      area_to_solid_angle(area.upper, hn::UpperHalf(half, distance_squared), hn::UpperHalf(half, cosine)),
      area_to_solid_angle(area.lower, hn::LowerHalf(half, distance_squared), hn::LowerHalf(half, cosine)));
}

HWY_ATTR HWY_INLINE LaneMask emits(EmissionSide side, Lanes cos_front) {
  const Lanes zero = hn::Zero(FloatTag());
  if (side == EmissionSide::both) return hn::Ne(cos_front, zero);
  return side == EmissionSide::front ? hn::Gt(cos_front, zero) : hn::Lt(cos_front, zero);
}

/// What comes along the directions from a light, with their density; where it does not arrive, what a
/// LightSample is by itself: nothing, of density 1.
HWY_ATTR HWY_INLINE void store_arriving(LaneMask arrives, const Lanes3& direction, const Lanes3& radiance,
                                        Lanes pdf, LightSamples& samples, std::size_t i) {
  store(zero_unless(arrives, direction), samples.direction, i);
  store(zero_unless(arrives, radiance), samples.radiance, i);
  store(select(arrives, pdf, splat(1)), samples.pdf, i);
}

/// Points of lights.
struct PointLanes {
  Lanes3 position, normal;
  Lanes offset;
};

HWY_ATTR HWY_INLINE Lanes end_offset(const Lanes3& between) {
  return hn::Mul(splat(twelve_roundings), max_abs(between));
}

/// The shadow rays from the surfaces to them: connect.
HWY_ATTR HWY_INLINE void store_ray_to(const PointLanes& to, const Surfaces& surfaces, LightSamples& samples,
                                      std::size_t i) {
  const Lanes3 between = to.position - load(surfaces.point.position, i);
  const Lanes3 origin = leave_surface(surfaces.point, i, between);
  const Lanes3 target =
      leave_surface(to.position, to.normal, hn::Add(to.offset, end_offset(between)), -between);
  store(origin, samples.origin, i);
  store(target - origin, samples.towards, i);
  store(splat(1), samples.t_max, i);
}

/// What a mesh light emits.
struct MeshEmission {
  Lanes3 radiance;
  EmissionSide side;
  DoubleHalves area;
};

/// Light of the points that have been chosen. Emission: that of one light, or of one of each lane.
template <typename Emission>
HWY_ATTR HWY_INLINE void sample_emitter(const Surfaces& surfaces, const Emission& light,
                                        LightSamples& samples, std::size_t i) {
  const WeightLanes weights = weights_of(load(samples.triangle.u, i), load(samples.triangle.v, i));
  const Lanes3 position = position_of(samples.triangle, samples.point.offset, i, weights);
  const Lanes3 normal = load(samples.point.normal, i);
  const Lanes3 between = position - load(surfaces.point.position, i);
  const Lanes squared = dot(between, between);
  const Lanes3 direction = between / hn::Sqrt(squared);
  const Lanes cos_front = hn::Neg(dot(normal, direction));
  const LaneMask arrives = hn::And(is_positive_and_finite(squared), emits(light.side, cos_front));
  const Lanes uniform = area_to_solid_angle(light.area, squared, cos_front);
  store_arriving(arrives, direction, light.radiance, hn::Mul(load(samples.density, i), uniform), samples, i);
  store_ray_to({position, normal, load(samples.point.offset, i)}, surfaces, samples, i);
}

HWY_ATTR void sample_mesh_light(const Surfaces& surfaces, const MeshLightRequest& light,
                                LightSamples& samples, std::size_t size) {
  const DoubleLanes area = hn::Set(DoubleTag(), light.area);
  const MeshEmission emission{splat(light.radiance), light.side, {area, area}};
  for (std::size_t i = 0; i < size; i += lane_count) sample_emitter(surfaces, emission, samples, i);
}

HWY_ATTR void sample_hemisphere(const Surfaces& surfaces, LightSamples& samples, std::size_t size) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes3 local = direction_around_z(load(samples.ux, i), load(samples.uy, i));
    const Lanes3 direction = to_world(load(surfaces.shading, i), local);
    store(direction, samples.direction, i);
    store(splat(1, 1, 1), samples.radiance, i);
    store(splat(1), samples.pdf, i);
    store(leave_surface(surfaces.point, i, direction), samples.origin, i);
    store(direction, samples.towards, i);
    store(splat(std::numeric_limits<float>::infinity()), samples.t_max, i);
  }
}

/// The indices of the lanes in the mask, from i on, written behind the first `count` of a list.
HWY_ATTR HWY_INLINE std::size_t append(LaneMask mask, std::size_t i, Words& list, std::size_t count) {
  const WordLanes indices = hn::Iota(WordTag(), std::uint32_t(i));
  return count +
         hn::CompressBlendedStore(indices, hn::RebindMask(WordTag(), mask), WordTag(), list.values + count);
}

HWY_ATTR HWY_INLINE LaneMask contains(const Zone& zone, const Lanes3& p) {
  const auto beyond = [](float low, Lanes x, float high) HWY_ATTR {
    const Lanes outside = hn::Max(hn::Sub(splat(low), x), hn::Sub(x, splat(high)));
    return hn::Max(outside, hn::Zero(FloatTag()));
  };
  const Lanes3 between{beyond(zone.box.lower.x, p.x, zone.box.upper.x),
                       beyond(zone.box.lower.y, p.y, zone.box.upper.y),
                       beyond(zone.box.lower.z, p.z, zone.box.upper.z)};
  return hn::Lt(dot(between, between), splat(zone.squared_distance));
}

/// The power heuristic within the zone, for samples that a surface scatters with the cosine z.
HWY_ATTR HWY_INLINE Lanes weight_of(const MisRequest& request, const Lanes3& position, Lanes pdf, Lanes z) {
  const Lanes one = splat(1);
  const Lanes scattered_pdf = hn::Div(hn::Abs(z), splat(pi));
  const Lanes ratio = hn::Div(scattered_pdf, hn::Mul(splat(request.count), pdf));
  return select(contains(request.zone, position), hn::Div(one, hn::Add(one, hn::Mul(ratio, ratio))), one);
}

HWY_ATTR void scatter_light(const Surfaces& surfaces, const LightSamples& samples, std::size_t size,
                            const MisRequest& mis, Connections& connections) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes3 direction = load(samples.direction, i);
    const Lanes z = dot(direction, load(surfaces.shading, i));
    const LaneMask reflects =
        hn::And(is_consistent(surfaces, i, direction), is_positive(hn::Mul(load(surfaces.wo_z, i), z)));
    Lanes3 scattered = zero_unless(reflects, bsdf(surfaces, i) * hn::Abs(z)) * load(samples.radiance, i);
    if (mis.zone.squared_distance > 0)
      scattered = scattered * weight_of(mis, load(surfaces.point.position, i), load(samples.pdf, i), z);
    store(scattered, connections.scattered, i);
  }
}

HWY_ATTR void make_shadow_rays(const LightSamples& samples, std::size_t size, Connections& connections) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; i += lane_count) {
    const LaneMask counts = hn::And(is_not_black(load(connections.scattered, i)), within(i, size));
    count = append(counts, i, connections.surface, count);
  }
  connections.size = count;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = connections.surface[k];
    connections.rays[k] = {.origin = samples.origin.at(i),
                           .direction = samples.towards.at(i),
                           .t_min = 0,
                           .t_max = samples.t_max[i]};
  }
}

HWY_ATTR void add_connections(const LightSamples& samples, std::size_t size, Connections& connections) {
  for (std::size_t i = 0; i < size; i += lane_count) {
    const Lanes3 scattered = load(connections.scattered, i);
    const Lanes3 term = scattered * load(connections.arriving, i) / load(samples.pdf, i);
    store(load(connections.of_light, i) + zero_unless(is_not_black(scattered), term), connections.of_light,
          i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
