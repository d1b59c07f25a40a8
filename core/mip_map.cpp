// SPDX-License-Identifier: Apache-2.0
#include "core/mip_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace twinray {
namespace {

/// What a pixel of a smaller row covers of a larger one: pixels from `first` on, with their parts.
struct Cover {
  int first = 0;
  std::vector<double> parts;  ///< Their sum is 1.
};

std::vector<Cover> covers(int large, int small) {
  const double ratio = double(large) / small;
  std::vector<Cover> all(static_cast<std::size_t>(small));
  for (int i = 0; i < small; ++i) {
    const double begin = i * ratio, end = std::min((i + 1) * ratio, double(large));
    Cover& cover = all[std::size_t(i)];
    cover.first = int(begin);
    for (int x = cover.first; x < large && x < end; ++x)
      cover.parts.push_back((std::min(x + 1.0, end) - std::max(double(x), begin)) / ratio);
  }
  return all;
}

Image halved(const Image& large) {
  Image small(std::max(large.width / 2, 1), std::max(large.height / 2, 1));
  const std::vector<Cover> columns = covers(large.width, small.width);
  const std::vector<Cover> rows = covers(large.height, small.height);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const Cover &column = columns[std::size_t(x)], &row = rows[std::size_t(y)];
      double r = 0, g = 0, b = 0;
      for (std::size_t j = 0; j < row.parts.size(); ++j)
        for (std::size_t i = 0; i < column.parts.size(); ++i) {
          const Rgb& pixel = large.at(column.first + int(i), row.first + int(j));
          const double part = row.parts[j] * column.parts[i];
          r += part * pixel.r, g += part * pixel.g, b += part * pixel.b;
        }
      small.at(x, y) = {float(r), float(g), float(b)};
    }
  return small;
}

bool is_within_unit(const Image& picture) {
  return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                     [](const Rgb& pixel) { return within_unit(pixel) == pixel; });
}

}  // namespace

MipMap::MipMap(std::vector<Image> levels)
    : levels_(std::move(levels)), is_within_unit_(twinray::is_within_unit(levels_.front())) {}

MipMap::MipMap(Image picture) : is_within_unit_(twinray::is_within_unit(picture)) {
  assert(!picture.pixels.empty());
  levels_.push_back(std::move(picture));
  while (levels_.back().pixels.size() > 1) {
    Image next = halved(levels_.back());
    levels_.push_back(std::move(next));
  }
}

Image MipMap::image(int index) const {
  if (is_in_memory()) return levels_[std::size_t(index)];
  const MipLevel from = level(index);
  Image copy(from.width, from.height);
  // Tile by tile: a row of tiles may be more than there is room for.
  for (int top = 0; top < copy.height; top += tile_side)
    for (int left = 0; left < copy.width; left += tile_side)
      for (int y = top; y < std::min(top + tile_side, copy.height); ++y)
        for (int x = left; x < std::min(left + tile_side, copy.width); ++x) copy.at(x, y) = from.at(x, y);
  return copy;
}

Rgb MipMap::mean() const {
  if (levels() > 1) return level(levels() - 1).at(0, 0);
  const Image picture = image(0);
  double r = 0, g = 0, b = 0;
  for (const Rgb& pixel : picture.pixels) r += double(pixel.r), g += double(pixel.g), b += double(pixel.b);
  const auto count = double(picture.pixels.size());
  return {float(r / count), float(g / count), float(b / count)};
}

std::shared_ptr<const MipMap> in_memory(const std::shared_ptr<const MipMap>& map) {
  if (map->is_in_memory()) return map;
  std::vector<Image> levels;
  for (int i = 0; i < map->levels(); ++i) levels.push_back(map->image(i));
  return std::make_shared<const MipMap>(std::move(levels));
}

}  // namespace twinray
