// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

namespace twinray::bench {

/// What is being done, on stderr: one line that is rewritten on a terminal, else a line whenever the heading
/// changes.
class Progress {
 public:
  Progress();
  /// Begins another part of the work.
  void begin(const std::string& heading);
  void show(const std::string& doing);
  /// Leaves the terminal's line empty.
  void finish();

 private:
  bool is_terminal_;
  std::string heading_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace twinray::bench
