// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "integrators/render.h"

namespace twinray {

/// One line on stderr that shows how far the work is: rewritten several times a second on a terminal, a line
/// of its own every few seconds elsewhere.
class ProgressLine {
 public:
  /// `enabled` false: prints nothing.
  explicit ProgressLine(bool enabled);
  /// Shows the state of a render, if the last time was long enough ago.
  void show(const RenderProgress& progress);
  /// The same for a text of one line.
  void show(const std::string& text);
  /// Clears the line on a terminal.
  void finish();

 private:
  bool is_due() const;
  using Clock = std::chrono::steady_clock;
  bool enabled_, is_terminal_, is_shown_ = false;
  Clock::time_point start_, last_;
};

/// "42 % · 1.2 M of 2.9 M samples · 3.1 M rays/s · 12 s, 17 s left".
std::string progress_text(const RenderProgress& progress, double elapsed_seconds);

/// "3 s", "2 min 5 s", "1 h 4 min".
std::string duration_text(double seconds);

}  // namespace twinray
