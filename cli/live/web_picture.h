// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/live/web_state.h"

namespace twinray {

/// A layer as it was after a pass; what it is once it was replaced stays with those who still read it.
struct WebCopy {
  std::uint64_t version = 0;  ///< Grows with each pass that is copied.
  std::shared_ptr<const LiveValues> values;
};

/// What pages see of a render. It is written by the render and read by the server's thread, and neither waits
/// for the other for longer than a few words take.
class WebPicture {
 public:
  /// The files, as in WebState.
  WebPicture(const std::string& picture, const std::string& partial);

  // For the render.

  void begin(const RenderOptions& options, const Scene& scene);
  void progress(const RenderProgress& progress);
  /// Whether a page asked within the last three seconds.
  bool is_watched() const;
  /// Whether one has asked for a picture since the last one was shown.
  bool is_awaited() const;
  /// Copies the layers that pages look at.
  void show(const Film& film);
  void show_last(const RenderResult& result);

  // For the server.

  /// How it is now.
  WebState state();
  /// The layer's number among the state's layers; none of that name: nothing.
  std::optional<std::size_t> layer_number(std::string_view name) const;
  /// A layer's last copy, if there is one. The layer is looked at from now on.
  WebCopy look_at(std::size_t layer);

  /// Asks for the end of the render. Throws Error where there is none, or where nothing would be kept of it.
  void stop();
  bool is_stopping() const { return is_stopping_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Look {
    WebCopy copy;
    Clock::time_point asked;  ///< When somebody last wanted to see it.
  };
  std::vector<std::size_t> watched_layers() const;
  void copy_layers(const Film& film);

  mutable std::mutex mutex_;
  std::atomic<bool> is_stopping_ = false;  ///< Asked for each pixel: no lock.
  WebState state_;
  std::vector<Look> looks_;  ///< One for each of the state's layers.
  std::uint64_t version_ = 0;
  Clock::time_point begun_, asked_, picture_asked_, shown_;
};

}  // namespace twinray
