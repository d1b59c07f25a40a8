// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>

#include "cli/render_arguments.h"
#include "cli/status/render_status.h"

namespace twinray {

/// --progress=json: on standard error an object a line, at each step's begin and each second. The first has
/// the scene and the output, too.
class JsonLines final : public StatusReporter {
 public:
  explicit JsonLines(const RenderArguments& arguments) : scene_(arguments.scene), output_(arguments.output) {}
  bool is_due() const override;
  void report(const RenderStatus& status) override;

 private:
  using Clock = std::chrono::steady_clock;
  std::string scene_, output_;
  bool is_first_ = true;
  Clock::time_point last_;
};

}  // namespace twinray
