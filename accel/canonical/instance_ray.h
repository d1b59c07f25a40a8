// SPDX-License-Identifier: Apache-2.0
// Private: how rays come into a scene that may have instances, and from there into one of them.
//
// In a scene with instances each ray's direction is scaled by a power of two, so that its largest component
// lies in [1, 2): so no instance's transform takes it out of the range in which load_ray() leaves t alone,
// and t is the same in all spaces.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "accel/canonical/checked_ray.h"
#include "accel/canonical/slab.h"
#include "core/geometry.h"

namespace twinray {

/// A ray whose direction has been divided by a power of two, and t multiplied by it.
struct ScaledRay {
  Ray ray;
  float power;
};

[[gnu::always_inline]] inline ScaledRay scaled(const Ray& given) {
  // Of numbers far from one load_ray() makes what is done here; those that are none it refuses.
  constexpr std::uint32_t one = 127, range = 60;
  const std::uint32_t exponent = std::bit_cast<std::uint32_t>(max_abs(given.direction)) >> 23;
  if (exponent < one - range || exponent > one + range) return {given, 1};
  const auto power = std::bit_cast<float>(exponent << 23);
  const auto inverse = std::bit_cast<float>((2 * one - exponent) << 23);
  return {{.origin = given.origin,
           .direction = given.direction * inverse,
           .t_min = given.t_min * power,
           .t_max = given.t_max < max_t ? given.t_max * power : given.t_max},
          power};
}

/// For a ray from beyond PlacedInstances::reach(): what boxes are widened by grows with its distance. (It is
/// not marked as cold: all of a query behind it then would be.)
[[gnu::noinline]] inline void widen_slabs(CheckedRay& checked, float margin) {
  const float reach = max_abs(checked.origin) * margin;
  for (int axis = 0; axis < 3; ++axis) {
    const float forward = checked.is_negative[axis] ? -reach : reach;
    checked.near_origin[axis] = checked.origin[axis] + forward;
    checked.far_origin[axis] = checked.origin[axis] - forward;
  }
}

/// What remains to be done when a scaled ray has been loaded into a scene with instances.
[[gnu::always_inline]] inline void finish_scaled(const PlacedInstances& placed, float power,
                                                 CheckedRay& checked) {
  if (power != 1) checked.t_scale = 1 / power;
  // What the caller takes for t is finite.
  if (power < 1) checked.t_max = checked.t_max < max_t * power ? checked.t_max : max_t * power;
  if (max_abs(checked.origin) > placed.reach()) widen_slabs(checked, placed.far_margin());
}

/// The origin and direction of a ray of the scene in the space of an instance.
[[gnu::always_inline]] inline void move_into(const PlacedInstance& instance, const CheckedRay& world,
                                             Ray& own) {
  const auto& m = instance.to_object.m;
  const double ox = world.origin.x, oy = world.origin.y, oz = world.origin.z;
  const double dx = world.direction.x, dy = world.direction.y, dz = world.direction.z;
  for (int row = 0; row < 3; ++row) {
    own.origin[row] = float(((m[row][0] * ox + m[row][1] * oy) + m[row][2] * oz) + m[row][3]);
    own.direction[row] = float((m[row][0] * dx + m[row][1] * dy) + m[row][2] * dz);
  }
}

/// A ray of the scene in the space of an instance, its interval up to t_max clipped to the instance's box;
/// false where nothing is left of it.
[[gnu::always_inline]] inline bool clip_to_instance(const PlacedInstance& instance, const CheckedRay& world,
                                                    float t_max, Ray& own) {
  const SlabInterval interval = intersect_slab(world, instance.box);
  own.t_min = interval.near > world.t_min ? interval.near : world.t_min;
  own.t_max = interval.far < t_max ? interval.far : t_max;
  if (!(own.t_min <= own.t_max)) return false;
  move_into(instance, world, own);
  return true;
}

/// Loads a ray of the scene into the space of an instance; false where it cannot hit it up to t_max.
inline bool enter_instance(const PlacedInstances& placed, std::uint32_t instance, const CheckedRay& world,
                           float t_max, CheckedRay& own) {
  Ray clipped;
  if (!clip_to_instance(placed[instance], world, t_max, clipped) || !load_ray(clipped, own)) return false;
  own.instance = instance;
  return true;
}

/// Loads a ray into the scene of a geometry; false for an invalid one, which is a miss.
inline bool load_ray_into(const Geometry& geometry, const Ray& given, CheckedRay& checked) {
  if (!geometry.has_instances()) return load_ray(given, checked);
  const ScaledRay ray = scaled(given);
  if (!load_ray(ray.ray, checked)) return false;
  finish_scaled(geometry.placed(), ray.power, checked);
  return true;
}

/// The hit that `trace` finds for a loaded ray, with t in the caller's units; an invalid ray is a miss.
template <typename Trace>
Hit closest_of(const Geometry& geometry, const Ray& ray, const Trace& trace) {
  Hit hit;  // The one variable that every path returns: copying what was just written in parts stalls.
  CheckedRay checked;
  if (!load_ray_into(geometry, ray, checked)) return hit;
  hit = trace(checked);
  checked.scale_back(hit);
  return hit;
}

/// Whether `trace` finds a hit for a loaded ray; an invalid ray is a miss.
template <typename Trace>
bool any_of(const Geometry& geometry, const Ray& ray, const Trace& trace) {
  CheckedRay checked;
  return load_ray_into(geometry, ray, checked) && trace(checked);
}

}  // namespace twinray
