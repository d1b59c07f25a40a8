// SPDX-License-Identifier: Apache-2.0
// What a render tells people while it goes on.
#pragma once
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "cli/denoising.h"
#include "cli/render_arguments.h"
#include "integrators/render.h"
#include "io/progress_line.h"
#include "io/scene_summary.h"

namespace twinray {

/// One function for each step of a render, called in this order; each says nothing unless it is overridden.
/// Warnings and errors are printed by whoever finds them.
class RenderTalk {
 public:
  virtual ~RenderTalk() = default;
  virtual void loading() {}
  virtual void loaded(const SceneSummary&) {}
  /// The picture could show more.
  virtual void note(const std::string&) {}
  /// Scene, camera and lights are there.
  virtual void ready() {}
  virtual void building(const RenderArguments&, const Geometry&) {}
  virtual void built(const AccelStats&) {}
  virtual void rendering() {}
  /// From one thread at a time.
  virtual void progress(const RenderProgress&) {}
  /// While it renders, and once it has ended.
  virtual void checkpointed() {}
  virtual void rendered(const RenderResult&) {}
  /// In place of rendered() or denoised(), and the last but for checkpointed(): it was interrupted.
  virtual void stopped() {}
  virtual void denoised(const DenoisedPicture&) {}
  virtual void saving() {}
  virtual void saved() {}
  virtual void finished(const RenderArguments&, const AccelStats&, const RenderResult&) {}
};

/// A line on standard error while it renders, where there is to be one, all else on standard output: what was
/// understood of the scene, and statistics at the end.
class StandardTalk final : public RenderTalk {
 public:
  explicit StandardTalk(ProgressKind progress);
  void loaded(const SceneSummary& summary) override;
  void note(const std::string& text) override;
  void rendering() override;
  void progress(const RenderProgress& progress) override;
  void rendered(const RenderResult& result) override;
  void stopped() override;
  void denoised(const DenoisedPicture& picture) override;
  void finished(const RenderArguments& arguments, const AccelStats& accel,
                const RenderResult& result) override;

 private:
  bool has_line_;
  ProgressLine line_;
};

}  // namespace twinray
