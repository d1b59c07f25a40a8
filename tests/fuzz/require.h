// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdlib>

namespace twinray::fuzz {

/// Ends the fuzzer with a finding unless it holds.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace twinray::fuzz
