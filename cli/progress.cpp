// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "cli/console.h"

namespace twinray {

ProgressLine progress_line(bool enabled) {
  const auto write = [](const std::string& text) { console::print_error("{}", text); };
  if (!enabled) return {false, nullptr};
  return {isatty(STDERR_FILENO) != 0, write};
}

std::string progress_text(const RenderProgress& progress, double elapsed_seconds) {
  const double of_samples =
      progress.samples_total == 0 ? 1 : double(progress.samples_done) / double(progress.samples_total);
  const double of_time = elapsed_seconds / progress.seconds_total;
  const double done = std::min(1.0, std::max(of_samples, of_time));
  const double rate = elapsed_seconds > 0 ? double(progress.rays) / elapsed_seconds : 0;
  std::string text = fmt::format("{:3.0f} % | {:.1f} ", 100 * done, 1e-6 * double(progress.samples_done));
  if (of_samples >= of_time) text += fmt::format("of {:.1f} ", 1e-6 * double(progress.samples_total));
  text += fmt::format("M samples | {:.2f} M rays/s | {}", 1e-6 * rate, duration_text(elapsed_seconds));
  if (done > 0.01) text += fmt::format(", {} left", duration_text(elapsed_seconds * (1 - done) / done));
  return text;
}

}  // namespace twinray
