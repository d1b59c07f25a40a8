// SPDX-License-Identifier: Apache-2.0
// Rotations that can be interpolated, and transforms in between of two.
#pragma once
#include "core/transform.h"

namespace twinray {

/// Of length 1 it is the rotation by twice the angle whose cosine is w, about the axis (x, y, z).
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

/// Of length 1; as it is where that cannot be.
Quaternion unit(const Quaternion& q);

/// Part `t` in [0, 1] of the way from one rotation to another, the shorter one, at constant speed
/// (Shoemake, "Animating Rotation with Quaternion Curves", 1985). They may have any length but 0; the result
/// has 1.
Quaternion slerp(const Quaternion& from, const Quaternion& to, double t);

/// The rotation; none for a quaternion without a direction.
Transform rotation_of(const Quaternion& q);

/// Of a matrix that rotates and does nothing else.
Quaternion quaternion_of(const Transform& rotation);

/// Part `t` in [0, 1] of the way from one transform to another: they are stretched, then rotated, then moved
/// (Shoemake and Duff, "Matrix Animation and Polar Decomposition", 1992), each of these evenly. Where one
/// mirrors and the other does not, there is a moment that flattens in between; where one flattens, the
/// matrices' numbers change evenly.
Transform interpolated(const Transform& from, const Transform& to, double t);

}  // namespace twinray
