// SPDX-License-Identifier: Apache-2.0
// --accel=check: another engine is asked for each ray of a render as well.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "check/render_check.h"
#include "cli/crosscheck/report.h"
#include "cli/live/live_layers.h"
#include "cli/render_arguments.h"

namespace twinray {

/// The other engine, and what is found. Arguments, scene and engine must outlive it.
class EngineCheck {
 public:
  EngineCheck(const RenderArguments& arguments, const Scene& scene, const Accelerator& accelerator);

  /// The options of a render whose rays come here.
  RenderOptions observed(RenderOptions options);
  /// "differences": the picture of them as it grows.
  LiveLayer layer() const;
  /// The rendered picture with the pixels where engines differ.
  Image picture(const Image& rendered) const { return account_.picture(rendered); }
  /// Of a render that took so long.
  SceneCrosscheck found(double seconds) const { return {names_, account_.report(), seconds}; }
  std::string json(const SceneCrosscheck& found) const;
  /// Prints the table, and what is wrong; `differences` is the picture of these, if there is one. The exit
  /// code.
  int report(const SceneCrosscheck& found, const std::string& differences) const;

 private:
  std::string label(const Finding& finding) const;
  std::string replay() const;

  const RenderArguments& arguments_;
  std::unique_ptr<const Accelerator> other_;
  std::vector<std::string> names_;
  RenderCheck account_;
};

}  // namespace twinray
