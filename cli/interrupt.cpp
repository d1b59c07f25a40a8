// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstring>

namespace twinray {
namespace {

// A signal handler can reach nothing but static storage; this is the program's only such state.
char unfinished_path[4096];

void end_at_once(int signal_number) {
  if (unfinished_path[0] != '\0') unlink(unfinished_path);
  const char newline = '\n';
  if (isatty(STDERR_FILENO) && write(STDERR_FILENO, &newline, 1) < 0) _exit(128 + signal_number);
  _exit(128 + signal_number);
}

}  // namespace

InterruptGuard::InterruptGuard(const std::string& unfinished_file) {
  if (unfinished_file.size() < sizeof(unfinished_path))
    std::memcpy(unfinished_path, unfinished_file.c_str(), unfinished_file.size() + 1);
  std::signal(SIGINT, end_at_once);
  std::signal(SIGTERM, end_at_once);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  unfinished_path[0] = '\0';
}

}  // namespace twinray
