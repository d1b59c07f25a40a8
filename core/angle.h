// SPDX-License-Identifier: Apache-2.0
// Constants of angles, in both precisions.
#pragma once

namespace twinray {

inline constexpr double pi_double = 3.14159265358979323846;
inline constexpr float pi = float(pi_double);
inline constexpr double radians_per_degree = pi_double / 180;
inline constexpr double degrees_per_turn = 360;

}  // namespace twinray
