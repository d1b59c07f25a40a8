// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

namespace twinray::study {

/// How large and how fine the pictures of a study are.
struct Scale {
  std::string name;
  int width = 0, height = 0;
  /// Numbers of samples above 64, as the write-ups have them, are divided by this.
  std::uint32_t divisor = 1;

  /// What stands for a number of samples of the write-ups.
  std::uint32_t samples(std::uint32_t full) const {
    constexpr std::uint32_t kept = 64;
    return full <= kept ? full : std::max(kept, full / divisor);
  }
};

inline const Scale quick{"quick", 96, 72, 16};
inline const Scale medium{"medium", 240, 180, 4};
inline const Scale full{"full", 480, 360, 1};

}  // namespace twinray::study
