// SPDX-License-Identifier: Apache-2.0
#include "cli/layered_picture.h"

namespace twinray {
namespace {

/// Appends the first `count` channels.
float* append(const Rgb& value, std::size_t count, float* to) {
  const float channels[] = {value.r, value.g, value.b};
  for (std::size_t i = 0; i < count; ++i) *to++ = channels[i];
  return to;
}

void fill_row(const Film& film, int y, std::span<float> values) {
  const PixelRect& window = film.window();
  float* next = values.data();
  std::vector<Rgb> layers(film.layers().size());
  for (int x = window.x0; x < window.x1; ++x) {
    next = append(film.pixel(x, y).mean(), 3, next);
    film.read_values(x, y, layers);
    for (std::size_t i = 0; i < layers.size(); ++i)
      next = append(layers[i], channel_count(film.layers()[i]), next);
  }
}

}  // namespace

LayeredImage layered_picture(const Film& film) {
  const PixelRect& window = film.window();
  LayeredImage image{window.width(), window.height(), {{"R"}, {"G"}, {"B"}}, {}};
  for (const Layer layer : film.layers())
    for (const char* const channel : layer_info(layer).channels)
      image.channels.push_back({channel, layer_info(layer).is_half});
  image.fill_row = [&film, first = window.y0](int y, std::span<float> values) {
    fill_row(film, first + y, values);
  };
  return image;
}

}  // namespace twinray
