// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <string>
#include <string_view>

#include "cli/render_talk.h"

namespace twinray {

/// The lines of CS184's program: in its order and form, each on its stream, for scripts that read them. With
/// another engine than a binary BVH they name that one.
class Cs184Talk final : public RenderTalk {
 public:
  explicit Cs184Talk(const RenderArguments& arguments) : arguments_(arguments) {}
  ~Cs184Talk() override;
  void loading() override;
  void ready() override;
  void building(const RenderArguments& arguments, const Geometry& geometry) override;
  void built(const AccelStats& stats) override;
  void rendering() override;
  void progress(const RenderProgress& progress) override;
  void rendered(const RenderResult& result) override;
  void stopped() override;
  void saving() override;
  void saved() override;
  void finished(const RenderArguments& arguments, const AccelStats& accel,
                const RenderResult& result) override;

 private:
  using Clock = std::chrono::steady_clock;
  /// Writes what stands before "Done!" of a step that may fail.
  void begin(std::string_view text, void (*write)(std::string_view) noexcept);
  /// "Done! (0.0136 sec)"
  void end_timed();

  const RenderArguments& arguments_;
  std::string engine_ = "BVH";
  bool counts_ = true;
  void (*open_line_)(std::string_view) noexcept = nullptr;  ///< Writes to where a line has no end yet.
  Clock::time_point step_start_;
  int percent_ = -1;
};

}  // namespace twinray
