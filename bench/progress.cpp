// SPDX-License-Identifier: Apache-2.0
#include "bench/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace twinray::bench {

Progress::Progress() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::begin(const std::string& heading) {
  heading_ = heading;
  if (!is_terminal_) std::fputs((heading + "\n").c_str(), stderr);
}

void Progress::show(const std::string& doing) {
  if (!is_terminal_) return;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start_).count();
  const std::string line =
      fmt::format("\r\x1b[K{} | {} | {}:{:02} min", heading_, doing, seconds / 60, seconds % 60);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

void Progress::finish() {
  if (is_terminal_) std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

}  // namespace twinray::bench
