// SPDX-License-Identifier: Apache-2.0
// Affine transforms in double: scene files compose long chains of them before a float vertex comes out.
#pragma once
#include "core/vec.h"

namespace twinray {

/// x -> A x + b: the upper three rows of a 4x4 matrix that acts on columns. Default: the identity.
struct Transform {
  double m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  friend bool operator==(const Transform&, const Transform&) = default;

  /// This transform after the other: (a * b)(x) = a(b(x)).
  Transform operator*(const Transform& other) const;
  Vec3 point(const Vec3& p) const;
  /// A direction: the translation does not take part.
  Vec3 vector(const Vec3& v) const;
  /// The transpose of A times a vector: a rotation's inverse.
  Vec3 transposed_vector(const Vec3& v) const;
  /// A normal of any length, as a unit vector that is perpendicular to its surface again, on the side that it
  /// was on: where A mirrors, the front stays the front. 0 0 0 where there is no direction: of a normal that
  /// has none, or where A flattens it away.
  Vec3 front(const Vec3& n) const;
  /// The determinant of A: negative where the transform mirrors, 0 where it flattens.
  double determinant() const;
  /// By how much A can make the largest component of a vector larger.
  double stretch() const;
  /// The transform back: A times its matrix is the identity but for 2^-48 times the condition of A, for
  /// conditions up to 2^20. Of no use where this one flattens.
  Transform inverse() const;

  static Transform translation(double x, double y, double z);
  static Transform scaling(double x, double y, double z);
  /// A turn about an axis (of any length but 0), counter-clockwise looking against the axis.
  static Transform rotation(const Vec3& axis, double angle_degrees);
};

}  // namespace twinray
