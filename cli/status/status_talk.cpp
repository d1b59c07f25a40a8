// SPDX-License-Identifier: Apache-2.0
#include "cli/status/status_talk.h"

#include <new>

#include "cli/status/json_lines.h"
#include "cli/status/metrics_file.h"

namespace twinray {
namespace {

using Step = RenderStatus::Step;

}  // namespace

std::vector<std::unique_ptr<StatusReporter>> status_reporters(const RenderArguments& arguments) {
  std::vector<std::unique_ptr<StatusReporter>> reporters;
  if (arguments.progress == ProgressKind::json) reporters.push_back(std::make_unique<JsonLines>(arguments));
  if (!arguments.metrics_file.empty()) reporters.push_back(std::make_unique<MetricsFile>(arguments));
  return reporters;
}

StatusTalk::~StatusTalk() {
  if (has_ended_) return;
  try {
    enter(Step::failed);
  } catch (const std::bad_alloc&) {  // Perhaps that is why it failed.
  }
}

void StatusTalk::take_times() {
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  status_.elapsed_seconds = since(start_);
  if (sampling_start_ && status_.step == Step::rendering) status_.sampling_seconds = since(*sampling_start_);
}

void StatusTalk::enter(Step step) {
  take_times();
  status_.step = step;
  for (const auto& reporter : reporters_) reporter->report(status_);
}

void StatusTalk::loading() {
  enter(Step::loading);
  people_.loading();
}

void StatusTalk::building(const RenderArguments& arguments, const Geometry& geometry) {
  enter(Step::building);
  people_.building(arguments, geometry);
}

void StatusTalk::rendering() {
  sampling_start_ = Clock::now();
  enter(Step::rendering);
  people_.rendering();
}

void StatusTalk::progress(const RenderProgress& progress) {
  people_.progress(progress);
  status_.progress = progress;
  for (const auto& reporter : reporters_)
    if (reporter->is_due()) {
      take_times();
      reporter->report(status_);
    }
}

void StatusTalk::checkpointed() {
  status_.checkpoint = std::chrono::system_clock::now();
  people_.checkpointed();
  if (has_ended_) enter(status_.step);  // Of an interrupted render the last checkpoint comes last.
}

void StatusTalk::stopped() {
  has_ended_ = true;
  people_.stopped();
  enter(Step::interrupted);
}

void StatusTalk::saving() {
  enter(Step::saving);
  people_.saving();
}

void StatusTalk::finished(const RenderArguments& arguments, const AccelStats& accel,
                          const RenderResult& result) {
  has_ended_ = true;
  enter(Step::done);
  people_.finished(arguments, accel, result);
}

}  // namespace twinray
