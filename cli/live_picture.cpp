// SPDX-License-Identifier: Apache-2.0
#include "cli/live_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/image.h"

namespace twinray {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds shortest_interval{250};
/// From one copy to the next, in lengths of a copy.
constexpr int rarity = 50;

ViewerPicture viewer_picture(const std::string& name, const Film& film) {
  const Image image = mean_image(film);
  ViewerPicture picture{name, image.width, image.height, {"R", "G", "B"}, {}};
  picture.values.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    picture.values.insert(picture.values.end(), {pixel.r, pixel.g, pixel.b});
  return picture;
}

}  // namespace

LivePicture::LivePicture(const std::optional<NetworkAddress>& address, const std::string& name)
    : address_(address), name_(name) {
  if (address) viewer_.emplace(*address);
}

RenderOptions LivePicture::watching(RenderOptions options) {
  if (viewer_) options.pass_done = [this](const Film& film) { show_pass(film); };
  return options;
}

void LivePicture::show_pass(const Film& film) {
  const Clock::time_point begin = Clock::now();
  if (begin < next_ || !viewer_->is_idle()) return;
  viewer_->show(viewer_picture(name_, film));
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(shortest_interval, rarity * (end - begin));
}

void LivePicture::show_last(const Film& film) {
  if (viewer_) viewer_->show(viewer_picture(name_, film));
}

std::string LivePicture::finish() {
  if (!viewer_) return "";
  viewer_->finish();
  const std::string fault = viewer_->fault();
  return fault.empty() ? ""
                       : fmt::format("--tev: the viewer at {} does not have the picture: {}",
                                     text_of(*address_), fault);
}

}  // namespace twinray
