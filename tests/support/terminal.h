// SPDX-License-Identifier: Apache-2.0
// The program on a terminal of its own, as somebody uses it who may press Ctrl-C.
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

namespace twinray::test {

/// A program that runs while the test goes on.
class TerminalProgram {
 public:
  /// Starts it with these words, and these variables ("NAME=value") on top of the environment.
  explicit TerminalProgram(const std::vector<std::string>& words,
                           const std::vector<std::string>& environment = {});
  ~TerminalProgram();
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;

  /// Waits until the text stands on the terminal; false where the program ends without it.
  bool wait_for(const std::string& text);
  /// Presses Ctrl-C.
  void press_control_c();
  void send(int signal_number);
  /// Waits for its end: the exit code, or 128 + the signal that ended it.
  int exit_code();
  /// All that stood on the terminal until now.
  const std::string& shown() const { return shown_; }

 private:
  bool read_more();

  pid_t process_ = -1;
  int terminal_ = -1;
  std::string shown_;
};

}  // namespace twinray::test
