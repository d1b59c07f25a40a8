// SPDX-License-Identifier: Apache-2.0
#include "cli/live/tev_window.h"

#include <fmt/format.h>

#include "core/image.h"

namespace twinray {
namespace {

ViewerPicture viewer_picture(const std::string& name, const Film& film) {
  const Image image = mean_image(film);
  ViewerPicture picture{name, image.width, image.height, {"R", "G", "B"}, {}};
  picture.values.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    picture.values.insert(picture.values.end(), {pixel.r, pixel.g, pixel.b});
  return picture;
}

}  // namespace

TevWindow::TevWindow(const NetworkAddress& address, const std::string& picture_name)
    : address_(address), name_(picture_name), viewer_(address) {}

void TevWindow::show(const Film& film) { viewer_.show(viewer_picture(name_, film)); }

std::string TevWindow::finish() {
  viewer_.finish();
  const std::string fault = viewer_.fault();
  return fault.empty()
             ? ""
             : fmt::format("--tev: the viewer at {} does not have the picture: {}", text_of(address_), fault);
}

}  // namespace twinray
