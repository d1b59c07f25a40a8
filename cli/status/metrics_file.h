// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

#include "cli/render_arguments.h"
#include "cli/status/render_status.h"

namespace twinray {

/// The text of a Prometheus metrics file: for each number its help, its type and its value, for each step
/// whether it is this one. Scene and output are labels of each, so that files of several renders go together.
std::string metrics_text(const RenderStatus& status, const std::string& scene, const std::string& output);

/// --metrics-file: written anew as a whole at each step's begin and every five seconds, or more rarely where
/// that would take more than a hundredth of the time.
class MetricsFile final : public StatusReporter {
 public:
  explicit MetricsFile(const RenderArguments& arguments);
  bool is_due() const override { return Clock::now() >= next_; }
  /// A file that cannot be written is a warning. Until the scene is read, this file may turn out to be a part
  /// of it, and a render that is refused may be so because of this file's name: until then it is written only
  /// where nothing can be lost.
  void report(const RenderStatus& status) override;

 private:
  using Clock = std::chrono::steady_clock;
  std::string path_, scene_, output_;
  bool may_write_;  ///< Also before the scene is read: what is there is of metrics, if there is anything.
  Clock::time_point next_;
};

}  // namespace twinray
