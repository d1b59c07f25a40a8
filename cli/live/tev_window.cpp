// SPDX-License-Identifier: Apache-2.0
#include "cli/live/tev_window.h"

#include <fmt/format.h>

#include "cli/layered_picture.h"

namespace twinray {
namespace {

ViewerPicture viewer_picture(const std::string& name, const LayeredImage& image) {
  ViewerPicture picture{name, image.width, image.height, {}, {}};
  for (const PictureChannel& channel : image.channels) picture.channels.push_back(channel.name);
  const std::size_t row = std::size_t(image.width) * image.channels.size();
  picture.values.resize(row * std::size_t(image.height));
  for (int y = 0; y < image.height; ++y)
    image.fill_row(y, std::span(picture.values).subspan(std::size_t(y) * row, row));
  return picture;
}

}  // namespace

TevWindow::TevWindow(const NetworkAddress& address, const std::string& picture_name)
    : address_(address), name_(picture_name), viewer_(address) {}

void TevWindow::begin(const RenderOptions& options, const Scene& scene, const std::vector<LiveLayer>&) {
  names_ = scene_names(scene, film_contents(options, scene));
}

void TevWindow::show(const Film& film) { viewer_.show(viewer_picture(name_, layered_picture(film, names_))); }

std::string TevWindow::finish() {
  viewer_.finish();
  const std::string fault = viewer_.fault();
  return fault.empty()
             ? ""
             : fmt::format("--tev: the viewer at {} does not have the picture: {}", text_of(address_), fault);
}

}  // namespace twinray
