// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/live/live_image.h"
#include "cli/live/web_state.h"

namespace twinray {

/// What pages see of a render. It is written by the render and read by the server's thread, and neither waits
/// for the other for longer than a row of tiles takes.
class WebPicture {
 public:
  /// The files, as in WebState.
  WebPicture(const std::string& picture, const std::string& partial);

  // For the render.

  void begin(const RenderOptions& options, const Scene& scene, const std::vector<LiveLayer>& more);
  void progress(const RenderProgress& progress);
  /// Whether a page asked within the last three seconds.
  bool is_watched() const;
  /// Whether one has asked for a picture since the last one was shown.
  bool is_awaited() const;
  /// Whether a page began to look at a layer whose tiles are old.
  bool needs_film() const { return needs_film_; }
  /// Copies what pages do not have of the layers that they look at.
  void show(const Film& film);
  /// Of a tile, where they have not had it for a while.
  void show_tile(const Film& film, const PixelRect& tile);
  void show_last(const RenderResult& result);

  // For the server.

  /// How it is now.
  WebState state();
  /// The layer's number among the state's layers; none of that name: nothing.
  std::optional<std::size_t> layer_number(std::string_view name) const;
  /// What there is of a layer, if anything. The layer is looked at from now on.
  std::shared_ptr<const LiveImage> look_at(std::size_t layer);

  /// Asks for the end of the render. Throws Error where there is none, or where nothing would be kept of it.
  void stop();
  bool is_stopping() const { return is_stopping_; }

 private:
  using Clock = LiveImage::Clock;
  struct Look {
    std::shared_ptr<LiveImage> image;  ///< None before somebody asked.
    Clock::time_point asked;           ///< When somebody last wanted to see it.
  };
  /// A layer that somebody saw.
  struct Seen {
    const LiveLayer& layer;
    std::shared_ptr<LiveImage> image;
    void copy(const Film& film, const PixelRect& tile) const;
  };
  void copy_old_tiles(const Film& film, const std::vector<Seen>& seen) const;
  /// Those that were asked for not longer ago than that.
  std::vector<Seen> seen(Clock::duration within) const;

  mutable std::mutex mutex_;
  std::atomic<bool> is_stopping_ = false;  ///< Asked for each pixel: no lock.
  std::atomic<bool> needs_film_ = false;
  WebState state_;
  PixelRect window_;         ///< Of the film.
  std::vector<Look> looks_;  ///< One for each of the state's layers.
  Clock::time_point begun_, asked_, picture_asked_, shown_;
};

}  // namespace twinray
