// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace twinray {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM end the program at once, with exit code 130 or 143, after
/// removing the unfinished file; whatever stood at the output's place stays. One at a time.
class InterruptGuard {
 public:
  explicit InterruptGuard(const std::vector<std::string>& files);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace twinray
