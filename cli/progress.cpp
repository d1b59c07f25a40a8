// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "cli/console.h"

namespace twinray {
namespace {

constexpr double terminal_interval_seconds = 0.1;
constexpr double log_interval_seconds = 5;

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = std::uint64_t(std::max(0.0, seconds) + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_text(const RenderProgress& progress, double elapsed_seconds) {
  const double done =
      progress.samples_total == 0 ? 1 : double(progress.samples_done) / double(progress.samples_total);
  const double rate = elapsed_seconds > 0 ? double(progress.rays) / elapsed_seconds : 0;
  std::string text = fmt::format("{:3.0f} % | {:.1f} of {:.1f} M samples | {:.2f} M rays/s | {}", 100 * done,
                                 1e-6 * double(progress.samples_done), 1e-6 * double(progress.samples_total),
                                 1e-6 * rate, duration_text(elapsed_seconds));
  if (done > 0.01) text += fmt::format(", {} left", duration_text(elapsed_seconds * (1 - done) / done));
  return text;
}

ProgressLine::ProgressLine(bool enabled)
    : enabled_(enabled), is_terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

bool ProgressLine::is_due() const {
  const std::chrono::duration<double> since_last = Clock::now() - last_;
  return enabled_ && since_last.count() >= (is_terminal_ ? terminal_interval_seconds : log_interval_seconds);
}

void ProgressLine::show(const RenderProgress& progress) {
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  if (is_due()) show(progress_text(progress, elapsed.count()));
}

void ProgressLine::show(const std::string& text) {
  if (!is_due()) return;
  last_ = Clock::now();
  is_shown_ = true;
  if (is_terminal_)
    console::print_error("\r{}\x1b[K", text);
  else
    console::print_error("{}\n", text);
}

void ProgressLine::finish() {
  if (is_shown_ && is_terminal_) console::print_error("\r\x1b[K");
}

}  // namespace twinray
