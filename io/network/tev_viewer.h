// SPDX-License-Identifier: Apache-2.0
// Pictures that grow, in a viewer that listens on a TCP port.
#pragma once
#include <memory>
#include <string>

#include "io/network/network_address.h"
#include "io/network/tev_packets.h"

namespace twinray {

/// Where a viewer listens: tev's own port of this machine, 14158, or what the text says otherwise
/// (parse_address()). Throws Error.
NetworkAddress parse_viewer_address(const std::string& text);

/// A connection to a viewer, by a thread of its own: whoever shows pictures never waits, whether the viewer
/// is slow, ends, comes back or was never there. A viewer that is not there is looked for each second.
class TevViewer {
 public:
  explicit TevViewer(const NetworkAddress& address);
  /// Finishes.
  ~TevViewer();
  TevViewer(const TevViewer&) = delete;
  TevViewer& operator=(const TevViewer&) = delete;

  /// Whether a picture would be on its way at once: a viewer is there, and has all that was shown.
  bool is_idle() const;
  /// The newest picture takes the place of one that is still waiting; all have the same size and channels.
  void show(ViewerPicture picture);
  /// No picture follows; gives the last one a second to arrive, where the viewer takes it.
  void finish();
  /// Why the viewer does not get pictures, or did not get the last one; "" where it does.
  std::string fault() const;

 private:
  struct State;
  std::shared_ptr<State> state_;  ///< Shared with the thread, which may outlive this where a name is sought.
};

}  // namespace twinray
