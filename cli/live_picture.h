// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>
#include <string>

#include "integrators/render.h"
#include "io/tev_viewer.h"

namespace twinray {

/// The picture of a render as it grows, in the viewer tev. It costs the render no more than a copy of the
/// picture now and then, and without a viewer nothing.
class LivePicture {
 public:
  /// Without an address there is nothing to show it to.
  LivePicture(const std::optional<NetworkAddress>& address, const std::string& name);

  /// The options of a render whose passes come here, as long as this lives: what there is after a pass is
  /// shown where the viewer has all before, and copies take 2 % of the time at most.
  RenderOptions watching(RenderOptions options);
  /// Shows what the render ended with.
  void show_last(const Film& film);
  /// Once nothing else is left to do: waits a second at most for a viewer that still reads. What is to be
  /// warned of: a viewer that does not have the last picture; else empty.
  std::string finish();

 private:
  using Clock = std::chrono::steady_clock;
  void show_pass(const Film& film);

  std::optional<NetworkAddress> address_;
  std::string name_;
  std::optional<TevViewer> viewer_;
  Clock::time_point next_;  ///< No copy before.
};

}  // namespace twinray
