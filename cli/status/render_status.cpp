// SPDX-License-Identifier: Apache-2.0
#include "cli/status/render_status.h"

#include <sys/resource.h>

#include "cli/progress.h"

namespace twinray {
namespace {

using Step = RenderStatus::Step;

double seconds_of(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

double since_1970(WallTime time) { return std::chrono::duration<double>(time.time_since_epoch()).count(); }

/// A render that is done is done as a whole, though it may have ended before what could have ended it.
double share_done(const RenderStatus& status, const RenderProgress& progress) {
  return status.step == Step::saving || status.step == Step::done
             ? 1
             : progress_shares(progress, status.sampling_seconds).most();
}

}  // namespace

const char* step_name(Step step) {
  switch (step) {
    case Step::loading:
      return "loading";
    case Step::building:
      return "building";
    case Step::rendering:
      return "rendering";
    case Step::saving:
      return "saving";
    case Step::done:
      return "done";
    case Step::interrupted:
      return "interrupted";
    case Step::failed:
      return "failed";
  }
  return "";
}

std::vector<Step> render_steps() {
  return {Step::loading, Step::building,    Step::rendering, Step::saving,
          Step::done,    Step::interrupted, Step::failed};
}

std::vector<StatusNumber> status_numbers(const RenderStatus& status) {
  const std::optional<RenderProgress>& progress = status.progress;
  const auto known = [&](auto value) {
    return progress ? std::optional(double(value(*progress))) : std::nullopt;
  };
  const bool is_rendering = progress && status.step == Step::rendering;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return {{"progress_ratio", "How much of the samples, the time or the noise target is reached",
           known([&](const RenderProgress& p) { return share_done(status, p); })},
          {"samples_done",
           "Samples of all pixels, with those of earlier processes and those that adaptive sampling saved",
           known([](const RenderProgress& p) { return p.samples_done; })},
          {"samples_wanted", "Samples of all pixels, at most",
           known([](const RenderProgress& p) { return p.samples_total; })},
          {"rays_done", "Rays, with those of earlier processes",
           known([](const RenderProgress& p) { return p.rays; })},
          {"rays_per_second", "The mean until now",
           known([&](const RenderProgress& p) { return rays_per_second(p, status.sampling_seconds); })},
          {"error_ratio", "The picture's relative error after its last pass, where there is a noise target",
           progress ? progress->error : std::nullopt},
          {"noise_target_ratio", "The relative error at which the render ends",
           progress ? progress->noise_target : std::nullopt},
          {"elapsed_seconds", "Since the process began with the scene", status.elapsed_seconds},
          {"left_seconds", "Until the render's end, if it goes on like this",
           is_rendering ? seconds_left(*progress, status.sampling_seconds) : std::nullopt},
          {"checkpoint_time_seconds", "When the process wrote its last checkpoint, since 1970",
           status.checkpoint ? std::optional(since_1970(*status.checkpoint)) : std::nullopt},
          {"update_time_seconds", "When these numbers were taken, since 1970",
           since_1970(std::chrono::system_clock::now())},
          {"cpu_seconds", "CPU time of the process", seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)},
          {"peak_memory_bytes", "The most memory that the process had", 1024.0 * double(usage.ru_maxrss)}};
}

}  // namespace twinray
