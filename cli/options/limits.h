// SPDX-License-Identifier: Apache-2.0
// What the process may take of the machine, kept by the kernel.
#pragma once
#include <optional>

namespace twinray {

struct ProcessLimits {
  std::optional<double> megabytes;  ///< Of memory that is the process's own, stacks of threads included.
  std::optional<double> seconds;    ///< More than 0; then the process gets SIGALRM.
};

/// From now on. Where the process wants more memory it gets none, which is an error like any other. Throws
/// Error where that cannot be set.
void limit_process(const ProcessLimits& limits);

}  // namespace twinray
