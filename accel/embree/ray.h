// SPDX-License-Identifier: Apache-2.0
// Private: rays as Embree takes them. Every field is set: an old mask or hit would be believed.
#pragma once
#include "accel/embree/api.h"
#include "core/vec.h"

namespace twinray::embree {

/// The bounds of t become +0 where they are -0, which Embree compares as an integer.
inline RTCRay make_ray(const Vec3& origin, const Vec3& direction, float t_min, float t_max) {
  RTCRay ray;
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.tnear = t_min + 0.0f;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.time = 0;
  ray.tfar = t_max + 0.0f;
  ray.mask = 0xffffffff;
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

/// The ray with a hit that says none.
inline RTCRayHit without_hit(const RTCRay& ray) {
  RTCRayHit result;
  result.ray = ray;
  result.hit = {};
  result.hit.primID = RTC_INVALID_GEOMETRY_ID;
  result.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  for (unsigned& instance : result.hit.instID) instance = RTC_INVALID_GEOMETRY_ID;
  return result;
}

}  // namespace twinray::embree
