// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "io/output_file.h"

namespace twinray {
namespace {

// A signal handler can reach nothing but static storage.
std::atomic<const std::vector<std::string>*> unfinished_paths = nullptr;
static_assert(std::atomic<const std::vector<std::string>*>::is_always_lock_free);

void end_at_once(int signal_number) {
  if (const std::vector<std::string>* paths = unfinished_paths)
    for (const std::string& path : *paths) unlink(path.c_str());
  const char newline = '\n';
  if (isatty(STDERR_FILENO) && write(STDERR_FILENO, &newline, 1) < 0) _exit(128 + signal_number);
  _exit(128 + signal_number);
}

}  // namespace

InterruptGuard::InterruptGuard(const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs)
    if (std::string path = temporary_path(output); !path.empty()) paths_.push_back(std::move(path));
  unfinished_paths = &paths_;
  struct sigaction action {};
  action.sa_handler = end_at_once;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before_[i]);
    // What was to be ignored still is: a job that its shell put into the background, or nohup's.
    if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  unfinished_paths = nullptr;
}

}  // namespace twinray
