// SPDX-License-Identifier: Apache-2.0
// A ray that goes straight on behind a surface. It stays the same ray and only begins later: moved off the
// surface, it would miss whatever lies just behind.
#pragma once
#include <cmath>
#include <limits>

#include "core/ray.h"
#include "core/surface.h"

namespace twinray {

/// The part of a ray that lies behind its hit at t. Of several surfaces with the same t the first one hides
/// the others; their order is that of the scene (accel/accelerator.h).
inline Ray straight_on(Ray ray, float t) {
  ray.t_min = std::nextafter(t, std::numeric_limits<float>::infinity());
  return ray;
}

/// A surface that it went through.
struct Crossing {
  SurfacePoint point;
  float t;
};

/// Whether two of them, one after the other, are one crossing of a shape on an edge of two of its triangles:
/// both are on the same side of it, and no farther apart than what rounding explains.
inline bool are_one(const Crossing& a, const Crossing& b, const Vec3& direction) {
  return a.point.shape == b.point.shape && a.point.instance == b.point.instance &&
         (dot(a.point.geometric_normal, direction) > 0) == (dot(b.point.geometric_normal, direction) > 0) &&
         (b.t - a.t) * length(direction) <= a.point.offset + b.point.offset;
}

}  // namespace twinray
