// SPDX-License-Identifier: Apache-2.0
// What Ctrl-C does, and other signals.
#pragma once
#include <signal.h>

#include <array>
#include <string>
#include <vector>

namespace twinray {

/// While it lives, Ctrl-C (SIGINT), SIGTERM, the end of the terminal (SIGHUP) and of the CPU time that is
/// allowed (SIGXCPU) or of all time (SIGALRM) end the program at once, with a message and exit code 130, 143,
/// 129, 152 or 142, after removing the unfinished files; whatever stood at the outputs' places stays. A
/// signal that the program was started to ignore is ignored. One within the life of another takes its place.
class InterruptGuard {
 public:
  /// What outputs are worth while others are not finished: as much as ever, or nothing. Then those that were
  /// not there before are removed, finished or not.
  enum class Outputs { apart, together };

  /// `early_code`, if not 0, is the exit code of a program that ends at once. Throws Error for a name that
  /// cannot be written.
  explicit InterruptGuard(const std::vector<std::string>& outputs, int early_code = 0,
                          Outputs are = Outputs::apart);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGALRM};
  std::vector<std::string> paths_;  ///< Where unfinished files are.
  int code_before_;                 ///< The early code of the one whose place it takes.
  std::array<struct sigaction, signals.size()> before_{};
};

/// While it lives, within the life of an InterruptGuard, the first such signal only asks the work to stop;
/// the second ends the program, but for one within a second that is not Ctrl-C's: it is the same request.
/// One at a time.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Asks the work to stop as the first Ctrl-C does; from any thread, and as often as you like.
  void make() const;
  /// Whether the work is to stop; from any thread.
  bool is_made() const;
  /// The exit code of a program that was asked to stop: 130, 143, 129, 152 or 142.
  int exit_code() const;
  /// Why it stops, for a message: "interrupted", or that its time is over.
  const char* text() const;
};

/// While it lives, SIGUSR1 asks for the picture as it is so far. One at a time.
class PictureRequest {
 public:
  PictureRequest();
  ~PictureRequest();
  PictureRequest(const PictureRequest&) = delete;
  PictureRequest& operator=(const PictureRequest&) = delete;

  /// From any thread.
  bool is_made() const;
  /// Whether it is made; from then on it is not.
  bool take();

 private:
  struct sigaction before_ {};
};

}  // namespace twinray
