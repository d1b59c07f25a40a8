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

/// Of what a file has.
struct Source {
  const Film& film;
  const Image* denoised;  ///< Null: there is none.
};

void fill_row(const Source& source, int row, std::span<float> values) {
  const Film& film = source.film;
  const PixelRect& window = film.window();
  const int y = window.y0 + row;
  float* next = values.data();
  std::vector<Rgb> layers(film.layers().size());
  for (int x = window.x0; x < window.x1; ++x) {
    const Rgb mean = film.pixel(x, y).mean();
    next = append(source.denoised ? source.denoised->at(x - window.x0, row) : mean, 3, next);
    film.read_values(x, y, layers);
    for (std::size_t i = 0; i < layers.size(); ++i)
      next = append(layers[i], channel_count(film.layers()[i]), next);
    if (source.denoised) next = append(mean, 3, next);
  }
}

}  // namespace

LayeredImage layered_picture(const Film& film, const Image* denoised) {
  const PixelRect& window = film.window();
  LayeredImage image{window.width(), window.height(), {{"R"}, {"G"}, {"B"}}, {}};
  for (const Layer layer : film.layers())
    for (const char* const channel : layer_info(layer).channels)
      image.channels.push_back({channel, layer_info(layer).is_half});
  if (denoised)
    for (const char* const channel : {"noisy.R", "noisy.G", "noisy.B"}) image.channels.push_back({channel});
  image.fill_row = [source = Source{film, denoised}](int y, std::span<float> values) {
    fill_row(source, y, values);
  };
  return image;
}

}  // namespace twinray
