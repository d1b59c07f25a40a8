// SPDX-License-Identifier: Apache-2.0
// Counts the memory of operator new. The program that links counted_memory.cpp has all of its own replaced.
#pragma once
#include <cstddef>

namespace twinray::test {

/// The most bytes of operator new at any one time while it lives, beyond those at its start. One at a time.
class PeakMemory {
 public:
  PeakMemory();
  std::size_t bytes() const;

 private:
  std::size_t start_;
};

}  // namespace twinray::test
