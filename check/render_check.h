// SPDX-License-Identifier: Apache-2.0
// The rays of a render, each traced by a second engine as well.
//
// The picture is that of the first engine: it traces as always, and the check compares both engines
// afterwards.
#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "check/crosscheck.h"
#include "core/image.h"
#include "integrators/render.h"

namespace twinray {

class RenderCheck {
 public:
  /// `reference` is the render's engine, which must be canonical; both engines must outlive this. Memory: one
  /// byte a pixel, and `kept` findings of each ray class.
  RenderCheck(std::shared_ptr<const Geometry> geometry, const CheckedEngine& reference,
              const CheckedEngine& other, const RenderOptions& options, std::size_t kept = 10);

  /// What RenderOptions::observe is set to.
  void observe(const PixelSample& sample, std::span<const RecordedRay> rays);

  /// Of engine 0, the reference, and engine 1, once the render is complete. The number of a finding is that
  /// of its sample; unexplained ones are judged.
  CrosscheckReport report() const;
  /// The sample that traced a finding's ray.
  PixelSample sample_of(const Finding& finding) const;
  /// What shows a pixel of this colour: dark and grey or, where it has a differing ray, red if that is
  /// unexplained, yellow if it is explained but more than rounding.
  Rgb shown(int x, int y, const Rgb& rendered) const;
  /// The rendered picture with all pixels so.
  Image picture(const Image& rendered) const;

 private:
  enum class Mark : std::uint8_t { none, explained, unexplained };

  std::size_t place(int x, int y) const {
    return std::size_t(y - window_.y0) * std::size_t(window_.width()) + std::size_t(x - window_.x0);
  }

  std::shared_ptr<const Geometry> geometry_;
  Crosscheck crosscheck_;
  int width_;
  std::uint32_t samples_;
  PixelRect window_;
  std::size_t kept_;
  std::vector<Mark> marks_;  ///< Of each pixel of the window, row by row. A pixel has one thread at a time.
  std::mutex mutex_;
  CrosscheckReport report_;
};

}  // namespace twinray
