// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <string>

namespace twinray {

/// One line that shows how far the work is: rewritten several times a second on a terminal, a line of its own
/// every few seconds elsewhere.
class ProgressLine {
 public:
  /// `write` gets the characters to be shown; without one nothing is.
  ProgressLine(bool is_terminal, std::function<void(const std::string&)> write);

  /// Shows a text of one line, if the last time was long enough ago.
  void show(const std::string& text);
  /// Whether show() would, so that a text need not be made in vain.
  bool is_due() const;
  /// Since the line was made.
  double elapsed_seconds() const;
  /// Clears the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_, is_shown_ = false;
  std::function<void(const std::string&)> write_;
  Clock::time_point start_, last_;
};

/// "3 s", "2 min 5 s", "1 h 4 min".
std::string duration_text(double seconds);

}  // namespace twinray
