// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "cli/live/live_layers.h"
#include "integrators/render.h"

namespace twinray {

/// Somebody who may look at a picture as it grows. None of the functions but finish() waits for anybody.
class PictureViewer {
 public:
  virtual ~PictureViewer() = default;
  /// What is going to be rendered; `more` may be looked at besides what its film keeps.
  virtual void begin(const RenderOptions&, const Scene&, const std::vector<LiveLayer>& /*more*/) {}
  /// After each tile, from one thread at a time.
  virtual void progress(const RenderProgress&) {}
  /// Whether somebody looks, and has all that was shown.
  virtual bool is_ready() const = 0;
  /// Copies what it needs of a film that rests.
  virtual void show(const Film& film) = 0;
  /// Whether it needs more of the film than tiles that are yet to come; from any thread.
  virtual bool needs_film() const { return false; }
  /// Copies what it needs of a tile, from the thread that rendered it, while others render others.
  virtual void show_tile(const Film&, const PixelRect&) {}
  /// The same of what the render ended with.
  virtual void show_last(const RenderResult& result) = 0;
  /// Once nothing else is left to do: waits a second at most for whoever still reads. What is to be warned
  /// of; else empty.
  virtual std::string finish() = 0;
  /// Whether whoever looks has asked for the end of the render; from any thread.
  virtual bool asks_to_stop() const { return false; }
};

}  // namespace twinray
