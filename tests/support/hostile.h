// SPDX-License-Identifier: Apache-2.0
// Rays and triangles chosen to hurt: through vertices, along edges, axis-parallel with zeros of both signs,
// from far away, through slivers, with directions of every size.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "core/ray.h"
#include "tests/support/random.h"

namespace twinray::test {

using Corners = std::array<Vec3, 3>;

struct HostilePair {
  Ray ray;
  Corners corners;
};

/// x moved by up to `steps` floats either way.
inline float nudged(Random& random, float x, int steps) {
  const int count = random.between(-steps, steps);
  for (int i = 0; i < std::abs(count); ++i) x = std::nextafter(x, count < 0 ? -INFINITY : INFINITY);
  return x;
}
inline Vec3 nudged(Random& random, Vec3 p, int steps) {
  for (int axis = 0; axis < 3; ++axis) p[axis] = nudged(random, p[axis], steps);
  return p;
}

/// A triangle of size 2^-10 to 2^10: anywhere, a sliver, parallel to an axis plane, on a lattice, or far from
/// the origin of space.
inline Corners hostile_triangle(Random& random) {
  const float size = std::ldexp(1.0f, random.between(-10, 10));
  Corners v{random.in_cube(size), random.in_cube(size), random.in_cube(size)};
  switch (random.below(6)) {
    case 0: {  // a sliver: the third corner close to a point of the edge of the others
      const float along = random.unit(), thickness = std::ldexp(size, -random.between(4, 22));
      v[2] = v[0] + (v[1] - v[0]) * along + random.in_cube(thickness);
      break;
    }
    case 1: {  // parallel to an axis plane
      const int axis = random.below(3);
      v[1][axis] = v[2][axis] = v[0][axis];
      break;
    }
    case 2:  // on a lattice
      for (Vec3& p : v)
        for (int axis = 0; axis < 3; ++axis) p[axis] = float(random.between(-3, 3));
      break;
    case 3: {  // far from the origin of space, compared with its size
      const Vec3 shift = random.in_cube(std::ldexp(size, random.between(1, 14)));
      for (Vec3& p : v) p = p + shift;
      break;
    }
    default:
      break;
  }
  return v;
}

/// A point of the triangle, of its edges, its vertices, or near by.
inline Vec3 hostile_target(Random& random, const Corners& v) {
  const float s = random.unit();
  const int k = random.below(3);
  const Vec3 on_edge = v[k] + (v[(k + 1) % 3] - v[k]) * s;
  switch (random.below(6)) {
    case 0:
      return v[k];
    case 1:
      return on_edge;
    case 2:
      return nudged(random, on_edge, 8);
    case 3:
      return nudged(random, v[k], 4);
    case 4:
      return on_edge + (v[(k + 2) % 3] - on_edge) * (1.5f * random.unit() - 0.25f);
    default:
      return on_edge + (v[(k + 2) % 3] - on_edge) * random.unit();
  }
}

/// An origin from which the target is seen: near, in the triangle's plane, at a vertex, straight along an
/// axis, or far away.
inline Vec3 hostile_origin(Random& random, const Corners& v, const Vec3& target) {
  const float size = std::max(max_abs(v[1] - v[0]), max_abs(v[2] - v[0]));
  switch (random.below(6)) {
    case 0: {  // an axis-parallel ray, or one parallel to an axis plane
      Vec3 origin = target;
      origin[random.below(3)] += size * random.uniform(-4, 4);
      if (random.below(2)) origin[random.below(3)] += size * random.uniform(-4, 4);
      return origin;
    }
    case 1: {  // nearly or quite in the plane
      const Vec3 along = (v[1] - v[0]) * random.uniform(-3, 3);
      const Vec3 across = (v[2] - v[0]) * random.uniform(-3, 3);
      return nudged(random, v[0] + along + across, 2);
    }
    case 2: {  // far away
      const Vec3 away = random.in_ball();
      return target + away * std::ldexp(1.0f, random.between(10, 59));
    }
    case 3:  // close to the target
      return target + random.in_cube(std::ldexp(size, -random.between(1, 20)));
    default:
      return target + random.in_cube(4 * size);
  }
}

inline Vec3 hostile_direction(Random& random, const Vec3& origin, const Vec3& target) {
  Vec3 d = target - origin;
  if (random.below(4) == 0) d = nudged(random, d, 3);
  if (max_abs(d) == 0 || random.below(40) == 0) {  // exactly along an axis
    d = {};
    d[random.below(3)] = random.below(2) ? 1.0f : -1.0f;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (d[axis] == 0 && random.below(2)) d[axis] = -0.0f;
  if (random.below(2)) return d;
  const int exponent = random.between(-60, 60) - std::ilogb(max_abs(d));
  for (int axis = 0; axis < 3; ++axis) d[axis] = std::ldexp(d[axis], exponent);
  return d;
}

/// A ray near the triangle, over all t >= 0.
inline HostilePair hostile_pair(Random& random) {
  const Corners corners = hostile_triangle(random);
  const Vec3 target = hostile_target(random, corners);
  const Vec3 origin = hostile_origin(random, corners, target);
  return {{.origin = origin, .direction = hostile_direction(random, origin, target)}, corners};
}

}  // namespace twinray::test
