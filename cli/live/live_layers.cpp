// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_layers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "cli/layered_picture.h"
#include "io/picture/plain_picture.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "values go out as they lie in memory");

const std::vector<std::string> rgb{"R", "G", "B"};

/// "albedo.R", "albedo.G", "albedo.B" -> "R", "G", "B"; "objectId.X", "materialId.X" -> "objectId",
/// "materialId".
std::vector<std::string> short_names(const std::vector<std::string>& channels) {
  std::vector<std::string> stems, endings;
  for (const std::string& channel : channels) {
    const std::size_t dot = channel.rfind('.');
    stems.push_back(channel.substr(0, dot));
    endings.push_back(channel.substr(dot + 1));  // all of it where there is no dot
  }
  const bool share_stem =
      std::count(stems.begin(), stems.end(), stems.front()) == std::ptrdiff_t(stems.size());
  return share_stem ? endings : stems;
}

LiveLayer layer_of(Layer layer, std::size_t index) {
  return {layer_info(layer).name, short_names(layer_info(layer).channels), LiveLayer::Kind::layer, index};
}

Rgb part_of(const Film& film, const LiveLayer& layer, int x, int y) {
  static thread_local std::vector<Rgb> parts;
  parts.resize(film.contents().parts[std::size_t(layer.division)]);
  film.read_parts(layer.division, x, y, parts);
  return parts[layer.index];
}

Rgb value_of(const Film& film, const LiveLayer& layer, int x, int y) {
  if (layer.kind == LiveLayer::Kind::layer) return film.value(layer.index, x, y);
  if (layer.kind == LiveLayer::Kind::part) return part_of(film, layer, x, y);
  return film.pixel(x, y).mean();
}

}  // namespace

std::vector<LiveLayer> live_layers(const FilmContents& contents,
                                   const std::vector<std::string>& light_groups) {
  std::vector<LiveLayer> layers{{"beauty", rgb}};
  for (std::size_t i = 0; i < contents.layers.size(); ++i)
    if (layer_info(contents.layers[i]).gathering != Gathering::coverage)
      layers.push_back(layer_of(contents.layers[i], i));
  const auto& [paths, groups] = contents.parts;
  for (std::size_t i = 0; i < paths; ++i)
    layers.push_back({light_path_name(LightPath(i)), rgb, LiveLayer::Kind::part, i, Division::paths});
  for (std::size_t i = 0; i < groups; ++i)
    layers.push_back({light_group_layer(light_groups[i]), rgb, LiveLayer::Kind::part, i, Division::groups});
  return layers;
}

LiveValues live_values(const Film& film, const LiveLayer& layer) {
  const PixelRect& window = film.window();
  const std::size_t bytes = layer.channels.size() * sizeof(float);
  LiveValues values{window.width(), window.height(), {}};
  values.bytes.resize(bytes * std::size_t(values.width) * std::size_t(values.height));
  char* next = values.bytes.data();
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x, next += bytes) {
      const Rgb value = value_of(film, layer, x, y);
      const float channels[] = {value.r, value.g, value.b};
      std::memcpy(next, channels, bytes);
    }
  return values;
}

std::string pfm_of(const LiveValues& values, std::size_t channels) {
  Image image(values.width, values.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    std::array<float, 3> pixel{};
    std::memcpy(pixel.data(), values.bytes.data() + i * channels * sizeof(float), channels * sizeof(float));
    image.pixels[i] = {pixel[0], pixel[1], pixel[2]};
  }
  return encode_pfm(image, channels == 1 ? 1 : 3);
}

}  // namespace twinray
