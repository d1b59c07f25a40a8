// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "integrators/render.h"

namespace twinray {

/// Somebody who may look at a picture as it grows. The functions are called in this order, and none waits
/// for anybody but finish().
class PictureViewer {
 public:
  virtual ~PictureViewer() = default;
  /// What is going to be rendered.
  virtual void begin(const RenderOptions&, const Scene&) {}
  /// After each tile, from one thread at a time.
  virtual void progress(const RenderProgress&) {}
  /// Whether somebody looks, and has all that was shown.
  virtual bool is_ready() const = 0;
  /// Copies what it needs of a film whose pixels have all samples of the passes until now.
  virtual void show(const Film& film) = 0;
  /// The same of what the render ended with.
  virtual void show_last(const RenderResult& result) = 0;
  /// Once nothing else is left to do: waits a second at most for whoever still reads. What is to be warned
  /// of; else empty.
  virtual std::string finish() = 0;
  /// Whether whoever looks has asked for the end of the render; from any thread.
  virtual bool asks_to_stop() const { return false; }
};

}  // namespace twinray
