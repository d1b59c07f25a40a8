// SPDX-License-Identifier: Apache-2.0
#include "core/phase_function.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/warp.h"

namespace twinray {
namespace {

/// Below it, the lobe is even to the precision of floats, and the inverse of its distribution divides by
/// almost 0.
constexpr float least_anisotropy = 1e-3f;

}  // namespace

float PhaseFunction::evaluate(float cosine) const {
  // 1 + g^2 - 2 g cos, as a sum of numbers that are not negative.
  const float narrow = 1 - std::fabs(g_);
  const float turned = g_ < 0 ? 1 + cosine : 1 - cosine;
  const float squared = narrow * narrow + 2 * std::fabs(g_) * std::max(turned, 0.0f);
  return (1 - g_ * g_) / (4 * pi * squared * std::sqrt(squared));
}

Vec3 PhaseFunction::sample(Vec2 u) const {
  float cosine = 1 - 2 * u.x;
  if (std::fabs(g_) >= least_anisotropy) {
    const float ratio = (1 - g_ * g_) / (1 - g_ + 2 * g_ * u.x);
    cosine = std::clamp((1 + g_ * g_ - ratio * ratio) / (2 * g_), -1.0f, 1.0f);
  }
  const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  const SinCos turn = sincos_turns(u.y);
  return {sine * turn.cos, sine * turn.sin, -cosine};
}

}  // namespace twinray
