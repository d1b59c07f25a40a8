// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_layers.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "cli/layered_picture.h"
#include "io/picture/plain_picture.h"

namespace twinray {
namespace {

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
  return {layer_info(layer).name, short_names(layer_info(layer).channels),
          [index](const Film& film, int x, int y) { return film.value(index, x, y); }};
}

LiveLayer part_of(const std::string& name, Division division, std::size_t index) {
  return {name, rgb, [division, index](const Film& film, int x, int y) {
            static thread_local std::vector<Rgb> parts;
            parts.resize(film.contents().parts[std::size_t(division)]);
            film.read_parts(division, x, y, parts);
            return parts[index];
          }};
}

}  // namespace

std::vector<LiveLayer> live_layers(const FilmContents& contents,
                                   const std::vector<std::string>& light_groups) {
  std::vector<LiveLayer> layers{
      {"beauty", rgb, [](const Film& film, int x, int y) { return film.pixel(x, y).mean(); }}};
  for (std::size_t i = 0; i < contents.layers.size(); ++i)
    if (layer_info(contents.layers[i]).gathering != Gathering::coverage)
      layers.push_back(layer_of(contents.layers[i], i));
  const auto& [paths, groups] = contents.parts;
  for (std::size_t i = 0; i < paths; ++i)
    layers.push_back(part_of(light_path_name(LightPath(i)), Division::paths, i));
  for (std::size_t i = 0; i < groups; ++i)
    layers.push_back(part_of(light_group_layer(light_groups[i]), Division::groups, i));
  return layers;
}

void read_tile(const Film& film, const LiveLayer& layer, const PixelRect& tile, std::vector<float>& values) {
  const std::size_t channels = layer.channels.size();
  values.clear();
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const Rgb value = layer.value(film, x, y);
      const std::array<float, 3> all{value.r, value.g, value.b};
      values.insert(values.end(), all.begin(), all.begin() + std::ptrdiff_t(channels));
    }
}

std::string pfm_of(const std::string& values, int width, int height, std::size_t channels) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    std::array<float, 3> pixel{};
    std::memcpy(pixel.data(), values.data() + i * channels * sizeof(float), channels * sizeof(float));
    image.pixels[i] = {pixel[0], pixel[1], pixel[2]};
  }
  return encode_pfm(image, channels == 1 ? 1 : 3);
}

}  // namespace twinray
