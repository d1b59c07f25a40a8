// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <memory>
#include <vector>

#include "cli/render_talk.h"
#include "cli/status/render_status.h"

namespace twinray {

/// Those to whom a render reports by its options: lines of JSON, a file of metrics.
std::vector<std::unique_ptr<StatusReporter>> status_reporters(const RenderArguments& arguments);

/// Tells people what another talk tells them, and reports the render's status besides. A render that
/// neither ended nor was interrupted when this ends has failed, also where it was refused before it began.
class StatusTalk final : public RenderTalk {
 public:
  /// `people` must outlive it.
  StatusTalk(RenderTalk& people, std::vector<std::unique_ptr<StatusReporter>> reporters)
      : people_(people), reporters_(std::move(reporters)) {}
  ~StatusTalk() override;
  void loading() override;
  void loaded(const SceneSummary& summary) override { people_.loaded(summary); }
  void note(const std::string& text) override { people_.note(text); }
  void ready() override { people_.ready(); }
  void building(const RenderArguments& arguments, const Geometry& geometry) override;
  void built(const AccelStats& stats) override { people_.built(stats); }
  void rendering() override;
  void progress(const RenderProgress& progress) override;
  void checkpointed() override;
  void rendered(const RenderResult& result) override { people_.rendered(result); }
  void stopped() override;
  void denoised(const DenoisedPicture& picture) override { people_.denoised(picture); }
  void saving() override;
  void saved() override { people_.saved(); }
  void finished(const RenderArguments& arguments, const AccelStats& accel,
                const RenderResult& result) override;

 private:
  using Clock = std::chrono::steady_clock;
  void take_times();
  void enter(RenderStatus::Step step);

  RenderTalk& people_;
  std::vector<std::unique_ptr<StatusReporter>> reporters_;
  RenderStatus status_;
  bool has_ended_ = false;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> sampling_start_;
};

}  // namespace twinray
