// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "core/vec.h"

namespace twinray {

/// An orthonormal basis around a unit normal, for directions seen from a surface (z is the normal).
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Frame {
  Vec3 tangent, bitangent, normal;

  explicit Frame(const Vec3& n) : normal(n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    tangent = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    bitangent = {b, sign + n.y * n.y * a, -n.y};
  }
  /// Of the same kind, with the tangent towards a direction that is not parallel to the normal; as above
  /// where it is.
  Frame(const Vec3& n, const Vec3& along) : Frame(n) {
    const Vec3 across = along - n * dot(along, n);
    const float squared = length_squared(across);
    if (!(squared > 0) || !std::isfinite(squared)) return;
    tangent = across / std::sqrt(squared);
    bitangent = cross(n, tangent);
  }
  Vec3 to_local(const Vec3& v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
  Vec3 to_world(const Vec3& v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
};

}  // namespace twinray
