// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cli/console.h"

namespace twinray {

ProgressLine progress_line(bool enabled) {
  const auto write = [](const std::string& text) { console::print_error("{}", text); };
  if (!enabled) return {false, nullptr};
  return {isatty(STDERR_FILENO) != 0, write};
}

namespace {

/// How much is done of what a noise target asks for: the error falls with the root of the samples, at least.
double share_of_target(const RenderProgress& progress) {
  if (!progress.error || !(*progress.error > 0)) return 0;
  const double ratio = *progress.noise_target / *progress.error;
  return ratio * ratio;
}

}  // namespace

ProgressShares progress_shares(const RenderProgress& progress, double elapsed_seconds) {
  return {progress.samples_total == 0 ? 1 : double(progress.samples_done) / double(progress.samples_total),
          elapsed_seconds / progress.seconds_total, share_of_target(progress)};
}

std::optional<double> seconds_left(const RenderProgress& progress, double elapsed_seconds) {
  const ProgressShares shares = progress_shares(progress, elapsed_seconds);
  const double done = std::min(1.0, std::max(shares.of_samples, shares.of_noise));
  double left = std::max(0.0, progress.seconds_total - elapsed_seconds);
  if (done > 0.01) left = std::min(left, (progress.seconds_before + elapsed_seconds) * (1 - done) / done);
  return std::isfinite(left) ? std::optional(left) : std::nullopt;
}

double rays_per_second(const RenderProgress& progress, double elapsed_seconds) {
  const double seconds = progress.seconds_before + elapsed_seconds;
  return seconds > 0 ? double(progress.rays) / seconds : 0;
}

std::string progress_text(const RenderProgress& progress, double elapsed_seconds) {
  const ProgressShares shares = progress_shares(progress, elapsed_seconds);
  std::string text =
      fmt::format("{:3.0f} % | {:.1f} ", 100 * shares.most(), 1e-6 * double(progress.samples_done));
  if (shares.of_samples >= std::max(shares.of_time, shares.of_noise))
    text += fmt::format("of {:.1f} ", 1e-6 * double(progress.samples_total));
  text += "M samples | ";
  if (progress.error)
    text += fmt::format("error {:.3g}, target {:.3g} | ", *progress.error, *progress.noise_target);
  text += fmt::format("{:.2f} M rays/s | {}", 1e-6 * rays_per_second(progress, elapsed_seconds),
                      duration_text(elapsed_seconds));
  if (const std::optional<double> left = seconds_left(progress, elapsed_seconds))
    text += fmt::format(", {} left", duration_text(*left));
  return text;
}

}  // namespace twinray
