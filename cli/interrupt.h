// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <signal.h>

#include <array>
#include <string>
#include <vector>

namespace twinray {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and the end of the terminal (SIGHUP) end the program at once,
/// with exit code 130, 143 or 129, after removing the unfinished file; whatever stood at the output's place
/// stays. A signal that the program was started to ignore is ignored. One at a time.
class InterruptGuard {
 public:
  /// Throws Error for a name that cannot be written.
  explicit InterruptGuard(const std::vector<std::string>& outputs);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::vector<std::string> paths_;  ///< Where unfinished files are.
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace twinray
