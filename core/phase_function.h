// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/vec.h"

namespace twinray {

/// In which directions a medium scatters light: Henyey and Greenstein's function ("Diffuse Radiation in the
/// Galaxy", 1941) of the angle by which light is turned, rotationally symmetric and reciprocal. It scatters
/// all light, so it is the density of its own directions, too.
class PhaseFunction {
 public:
  /// Beyond it, lobes are so narrow that directions of floats cannot tell them apart.
  static constexpr float most_anisotropy = 0.99f;

  /// The mean cosine of that angle, in [-0.99, 0.99]: 0 scatters evenly, above it mostly forward.
  explicit PhaseFunction(float anisotropy) : g_(anisotropy) {}

  /// Per steradian; by the cosine of the angle by which light is turned.
  float evaluate(float cosine) const;
  /// A unit vector, in a frame whose z axis is the direction that light comes from, so that -z is forward. u
  /// in [0, 1)^2.
  Vec3 sample(Vec2 u) const;

 private:
  float g_;
};

}  // namespace twinray
