// SPDX-License-Identifier: Apache-2.0
// Rays and spheres chosen to hurt, as hostile.h has them for triangles.
#pragma once
#include <cmath>

#include "core/geometry.h"
#include "tests/support/hostile.h"

namespace twinray::test {

struct RayAndSphere {
  Ray ray;
  Sphere sphere;
};

/// A ray near a sphere: through it, tangent to it, from its inside, its surface or far away.
inline RayAndSphere hostile_sphere(Random& random) {
  Sphere sphere{random.in_cube(std::ldexp(1.0f, random.between(-10, 10))),
                std::ldexp(random.uniform(1, 2), random.between(-20, 12))};
  const Vec3 normal = normalize(random.in_ball());
  Vec3 side = random.in_ball();
  side = normalize(side - normal * dot(side, normal));
  const Vec3 on_surface = sphere.center + normal * sphere.radius;
  const float distance = std::ldexp(sphere.radius, random.between(-3, 20));
  Vec3 origin = sphere.center + random.in_ball() * distance, target = on_surface;
  switch (random.below(6)) {
    case 0:  // tangent within rounding
      origin = on_surface + side * distance;
      break;
    case 1:  // from the surface
      origin = on_surface;
      target = origin + random.in_ball();
      break;
    case 2:  // from the inside
      origin = sphere.center + random.in_ball() * sphere.radius;
      break;
    case 3:  // from far away
      origin = target + random.in_ball() * std::ldexp(1.0f, random.between(10, 58));
      break;
    default:
      target = sphere.center + random.in_ball() * sphere.radius;
      break;
  }
  const Vec3 direction = hostile_direction(random, origin, target);
  return {{.origin = origin, .direction = direction}, sphere};
}

}  // namespace twinray::test
