// SPDX-License-Identifier: Apache-2.0
#include "io/progress_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace twinray {
namespace {

constexpr double terminal_interval_seconds = 0.1;
constexpr double log_interval_seconds = 5;

}  // namespace

ProgressLine::ProgressLine(bool is_terminal, std::function<void(const std::string&)> write)
    : is_terminal_(is_terminal), write_(std::move(write)), start_(Clock::now()), last_(start_) {}

bool ProgressLine::is_due() const {
  const std::chrono::duration<double> since_last = Clock::now() - last_;
  return write_ && since_last.count() >= (is_terminal_ ? terminal_interval_seconds : log_interval_seconds);
}

double ProgressLine::elapsed_seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ProgressLine::show(const std::string& text) {
  if (!is_due()) return;
  last_ = Clock::now();
  is_shown_ = true;
  write_(is_terminal_ ? fmt::format("\r{}\x1b[K", text) : text + "\n");
}

void ProgressLine::finish() {
  if (is_shown_ && is_terminal_) write_("\r\x1b[K");
}

std::string duration_text(double seconds) {
  const auto whole = std::uint64_t(std::max(0.0, seconds) + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace twinray
