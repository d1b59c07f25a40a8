// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/console.h"
#include "io/output_file.h"

namespace twinray {
namespace {

// A signal handler can reach nothing but static storage.
std::atomic<const std::vector<std::string>*> unfinished_paths = nullptr;
static_assert(std::atomic<const std::vector<std::string>*>::is_always_lock_free);

/// Of outputs that have no temporary name, such as standard output.
std::atomic<bool> is_lost_at_the_end = false;

/// Of a program that ends before it can be stopped; 0: that of the signal.
std::atomic<int> exit_code_before = 0;
std::atomic<bool> is_stoppable = false;
/// The first signal since the work can be stopped; 0 where there was none.
std::atomic<int> stop_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);
/// When it came, in nanoseconds of a clock that never goes back; 0 where there was none.
std::atomic<std::int64_t> stop_time = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);
/// Whoever stops a group of processes signals each of them, and so may a script among them: what comes again
/// so soon is the same request. Two Ctrl-C are two.
constexpr std::int64_t one_request = 1'000'000'000;

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::atomic<bool> is_picture_asked_for = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void ask_for_picture(int) { is_picture_asked_for = true; }

constexpr int exit_code_of(int signal_number) { return 128 + signal_number; }

/// Of work that a signal has stopped.
constexpr const char* stop_text(int signal_number) {
  return signal_number == SIGALRM ? "the time of --time-limit is over" : "interrupted";
}

void say(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(std::size_t(written));
  }
}

[[noreturn]] void end_at_once(int signal_number, int exit_code) {
  if (const std::vector<std::string>* paths = unfinished_paths)
    for (const std::string& path : *paths) unlink(path.c_str());
  if (isatty(STDERR_FILENO)) say("\n");
  say(console::speaker());
  say(": ");
  say(signal_number == SIGINT || signal_number == SIGALRM ? stop_text(signal_number) : "ended by a signal");
  if (unfinished_paths)
    say("; unfinished outputs are removed, old files are as they were");
  else if (is_lost_at_the_end)
    say("; the output is not finished");
  say("\n");
  _exit(exit_code);
}

void take_signal(int signal_number) {
  const int code_before = exit_code_before,
            code = code_before != 0 ? code_before : exit_code_of(signal_number);
  if (!is_stoppable) end_at_once(signal_number, code);
  int none = 0;
  std::int64_t first = 0;
  const bool is_first_time = stop_time.compare_exchange_strong(first, now());
  if (stop_signal.compare_exchange_strong(none, signal_number)) return;
  if (signal_number == SIGINT || is_first_time || now() - first >= one_request)
    end_at_once(signal_number, code);
}

}  // namespace

InterruptGuard::InterruptGuard(const std::vector<std::string>& outputs, int early_code, Outputs are)
    : code_before_(exit_code_before) {
  for (const std::string& output : outputs) {
    std::error_code ignored;
    const bool is_new =
        std::filesystem::symlink_status(output, ignored).type() == std::filesystem::file_type::not_found;
    if (are == Outputs::together && is_new) paths_.push_back(output);
    if (std::string path = temporary_path(output); !path.empty()) paths_.push_back(std::move(path));
  }
  if (!paths_.empty()) unfinished_paths = &paths_;
  is_lost_at_the_end = !outputs.empty();
  exit_code_before = early_code;
  struct sigaction action {};
  action.sa_handler = take_signal;
  action.sa_flags = SA_RESTART;  // Who is asked to stop still writes what it writes.
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before_[i]);
    // What was to be ignored still is: a job that its shell put into the background, or nohup's.
    if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  unfinished_paths = nullptr;
  is_lost_at_the_end = false;
  exit_code_before = code_before_;
}

StopRequest::StopRequest() {
  stop_signal = 0;
  stop_time = 0;
  is_stoppable = true;
}

StopRequest::~StopRequest() { is_stoppable = false; }

void StopRequest::make() const {
  int none = 0;
  stop_signal.compare_exchange_strong(none, SIGINT);
}

bool StopRequest::is_made() const { return stop_signal != 0; }

int StopRequest::exit_code() const { return exit_code_of(stop_signal); }

const char* StopRequest::text() const { return stop_text(stop_signal); }

PictureRequest::PictureRequest() {
  is_picture_asked_for = false;
  struct sigaction action {};
  action.sa_handler = ask_for_picture;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, &before_);
}

PictureRequest::~PictureRequest() { sigaction(SIGUSR1, &before_, nullptr); }

bool PictureRequest::is_made() const { return is_picture_asked_for; }

bool PictureRequest::take() { return is_picture_asked_for.exchange(false); }

}  // namespace twinray
