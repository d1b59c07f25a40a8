// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstring>

#include "io/output_file.h"

namespace twinray {
namespace {

// A signal handler can reach nothing but static storage; this is the program's only such state: the temporary
// paths, each ended by a zero, and another zero behind the last.
char unfinished_paths[16384];

void end_at_once(int signal_number) {
  for (const char* path = unfinished_paths; *path != '\0'; path += std::strlen(path) + 1) unlink(path);
  const char newline = '\n';
  if (isatty(STDERR_FILENO) && write(STDERR_FILENO, &newline, 1) < 0) _exit(128 + signal_number);
  _exit(128 + signal_number);
}

}  // namespace

InterruptGuard::InterruptGuard(const std::vector<std::string>& files) {
  std::size_t used = 0;
  for (const std::string& file : files) {
    const std::string path = temporary_path(file);
    if (used + path.size() + 2 > sizeof(unfinished_paths)) break;
    std::memcpy(unfinished_paths + used, path.c_str(), path.size() + 1);
    used += path.size() + 1;
  }
  unfinished_paths[used] = '\0';
  std::signal(SIGINT, end_at_once);
  std::signal(SIGTERM, end_at_once);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  unfinished_paths[0] = '\0';
}

}  // namespace twinray
