// SPDX-License-Identifier: Apache-2.0
// Private: rays as Embree takes them. Every field is set: an old mask or hit would be believed.
#pragma once
#include "accel/embree/api.h"
#include "core/vec.h"

namespace twinray::embree {

/// Writes a ray where Embree will read it: a copy of what was just written in parts stalls, 15 ns. The bounds
/// of t become +0 where they are -0, which Embree compares as an integer.
inline void set_ray(RTCRay& ray, const Vec3& origin, const Vec3& direction, float t_min, float t_max) {
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
}

/// Says that there is no hit; Embree reads nothing else of it.
inline void set_no_hit(RTCHit& hit) {
  hit.primID = RTC_INVALID_GEOMETRY_ID;
  hit.geomID = RTC_INVALID_GEOMETRY_ID;
  for (unsigned& instance : hit.instID) instance = RTC_INVALID_GEOMETRY_ID;
}

}  // namespace twinray::embree
