// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// The weight of a sample that two ways of sampling could have given, each with its density (times its number
/// of samples) by one measure, by the power heuristic (Veach 1997, exponent 2): that of the way that gave it,
/// > 0, and that of the other. The weights of both ways add up to 1.
inline float power_heuristic(float pdf, float other_pdf) {
  const float ratio = other_pdf / pdf;
  return 1 / (1 + ratio * ratio);
}

}  // namespace twinray
