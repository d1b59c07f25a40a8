// SPDX-License-Identifier: Apache-2.0
#include "bench/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace twinray::bench {

Progress::Progress() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::begin(const std::string& heading) {
  heading_ = heading;
  if (!is_terminal_) fmt::print(stderr, "{}\n", heading);
}

void Progress::show(const std::string& doing) {
  if (!is_terminal_) return;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start_).count();
  fmt::print(stderr, "\r\x1b[K{} | {} | {}:{:02} min", heading_, doing, seconds / 60, seconds % 60);
  std::fflush(stderr);
}

void Progress::finish() {
  if (is_terminal_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace twinray::bench
