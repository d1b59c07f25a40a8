// SPDX-License-Identifier: Apache-2.0
#include "check/render_check.h"

#include <algorithm>
#include <cmath>

#include "check/recorded_rays.h"

namespace twinray {
namespace {

/// How bright the picture is behind the marks, and where it ends.
constexpr float background = 0.25f;

/// Rays of both engines that are neither identical nor rounding.
std::uint64_t odd_rays(const CrosscheckReport& report) {
  std::uint64_t odd = 0;
  for (std::size_t engine = 0; engine < report.engine_count(); ++engine)
    for (const RayClass ray_class : {RayClass::camera, RayClass::shadow, RayClass::bounce})
      odd += report.tally(engine, ray_class).odd();
  return odd;
}

Rgb dark(const Rgb& color) {
  const float clipped = std::clamp(luminance(color), 0.0f, 1.0f);
  const float value = background * (std::isnan(clipped) ? 0 : clipped);
  return {value, value, value};
}

}  // namespace

RenderCheck::RenderCheck(std::shared_ptr<const Geometry> geometry, const CheckedEngine& reference,
                         const CheckedEngine& other, const RenderOptions& options, std::size_t kept)
    : geometry_(std::move(geometry)),
      crosscheck_(geometry_, {reference, other}),
      width_(options.width),
      samples_(options.samples),
      window_(window_of(options)),
      kept_(kept),
      marks_(std::size_t(window_.width()) * std::size_t(window_.height())),
      report_(2, kept) {}

void RenderCheck::observe(const PixelSample& sample, std::span<const RecordedRay> rays) {
  const std::uint64_t pixel = std::uint64_t(sample.y) * std::uint64_t(width_) + std::uint64_t(sample.x);
  CrosscheckReport part(2, kept_);
  for (const RecordedRay& recorded : rays)
    crosscheck_.check(recorded.ray, class_of(recorded.kind), pixel * samples_ + sample.index, part);
  Mark& mark = marks_[place(sample.x, sample.y)];
  if (part.unexplained() > 0)
    mark = Mark::unexplained;
  else if (odd_rays(part) > 0)
    mark = std::max(mark, Mark::explained);
  const std::lock_guard lock(mutex_);
  report_ += part;
}

CrosscheckReport RenderCheck::report() const {
  CrosscheckReport judged = report_;
  judged.judge(*geometry_, Placement::file);
  return judged;
}

PixelSample RenderCheck::sample_of(const Finding& finding) const {
  const std::uint64_t pixel = finding.number / samples_;
  return {int(pixel % std::uint64_t(width_)), int(pixel / std::uint64_t(width_)),
          std::uint32_t(finding.number % samples_)};
}

Rgb RenderCheck::shown(int x, int y, const Rgb& rendered) const {
  const Mark mark = marks_[place(x, y)];
  if (mark == Mark::none) return dark(rendered);
  return mark == Mark::unexplained ? Rgb{1, 0, 0} : Rgb{1, 1, 0};
}

Image RenderCheck::picture(const Image& rendered) const {
  Image image = rendered;
  for (int y = window_.y0; y < window_.y1; ++y)
    for (int x = window_.x0; x < window_.x1; ++x) {
      Rgb& pixel = image.pixels[place(x, y)];
      pixel = shown(x, y, pixel);
    }
  return image;
}

}  // namespace twinray
