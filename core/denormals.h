// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twinray {

/// Whether the calling thread computes with denormal numbers: neither FTZ nor DAZ is set. It computes one and
/// looks, which takes less than a nanosecond; to read the mode itself takes five. Volatile: no flag of a
/// user's compiler may reason about it.
inline bool keeps_denormals() {
  static constexpr float normal[2] = {0x1.8p-126f, 0x1p-126f};
  const volatile float* const operands = normal;
  const volatile float denormal = operands[0] - operands[1];
  return denormal != 0;
}

}  // namespace twinray
