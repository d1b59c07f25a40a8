// SPDX-License-Identifier: Apache-2.0
// What the process may take of the machine, kept by the kernel.
#pragma once
#include <cstdint>

namespace twinray {

/// From now on the process has at most so many bytes of memory that is its own, stacks of threads included:
/// where it wants more it gets none, which is an error like any other. Throws Error where that cannot be set.
void limit_memory(std::uint64_t bytes);

/// In so many seconds, more than 0, the process gets SIGALRM.
void limit_time(double seconds);

}  // namespace twinray
