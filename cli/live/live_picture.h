// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "cli/live/picture_viewer.h"

namespace twinray {

/// The picture of a render as it grows, for those who look at it. It costs the render no more than a copy of
/// the picture now and then, and where nobody looks nothing.
class LivePicture {
 public:
  explicit LivePicture(std::vector<std::unique_ptr<PictureViewer>> viewers) : viewers_(std::move(viewers)) {}

  /// The options of a render of the scene whose tiles and passes come here, as long as this lives: what there
  /// is after a pass is shown to whoever has all before, and copies take 2 % of the time at most. `more` may
  /// be looked at, too.
  RenderOptions watching(RenderOptions options, const Scene& scene, const std::vector<LiveLayer>& more = {});
  /// From one thread at a time.
  void progress(const RenderProgress& progress);
  /// Whether somebody who looks has asked for the end of the render; from any thread.
  bool asks_to_stop() const;
  /// Shows what the render ended with.
  void show_last(const RenderResult& result);
  /// Once nothing else is left to do: waits a second at most for those who still read, and warns of those who
  /// do not have the last picture.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void show_pass(const Film& film);
  bool needs_film() const;

  std::vector<std::unique_ptr<PictureViewer>> viewers_;
  Clock::time_point next_;  ///< No copy before.
};

}  // namespace twinray
