// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "integrators/render_options.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "values go out as they lie in memory");

/// A page asks four times a second.
constexpr std::chrono::milliseconds tile_interval{200};

void append(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

}  // namespace

LiveImage::LiveImage(const PixelRect& window, std::size_t channels)
    : window_(window),
      channels_(channels),
      grid_(tile_grid(window, tile_size)),
      tiles_(grid_.count()),
      values_(std::size_t(width()) * std::size_t(height()) * channels),
      missing_(tiles_.size()) {}

std::size_t LiveImage::number_of(const PixelRect& tile) const {
  return std::size_t((tile.y0 - window_.y0) / tile_size) * std::size_t(grid_.columns) +
         std::size_t((tile.x0 - window_.x0) / tile_size);
}

std::size_t LiveImage::place_of(const PixelRect& tile, int row) const {
  return (std::size_t(tile.y0 - window_.y0 + row) * std::size_t(width()) +
          std::size_t(tile.x0 - window_.x0)) *
         channels_;
}

bool LiveImage::is_due(const PixelRect& tile, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  Tile& known = tiles_[number_of(tile)];
  const bool is_due = known.version == 0 || now - known.put >= tile_interval;
  if (!is_due) known.is_old = true;
  return is_due;
}

bool LiveImage::is_old(const PixelRect& tile) const {
  const std::lock_guard lock(mutex_);
  return tiles_[number_of(tile)].is_old;
}

void LiveImage::age() {
  const std::lock_guard lock(mutex_);
  for (Tile& tile : tiles_) tile.is_old = true;
}

void LiveImage::put(const PixelRect& tile, std::span<const float> values, Clock::time_point now) {
  const std::size_t row_size = std::size_t(tile.width()) * channels_;
  const std::lock_guard lock(mutex_);
  Tile& known = tiles_[number_of(tile)];
  const bool is_first = known.version == 0;
  bool is_changed = is_first;
  for (int row = 0; row < tile.height(); ++row) {
    float* const to = values_.data() + place_of(tile, row);
    const float* const from = values.data() + std::size_t(row) * row_size;
    if (std::memcmp(to, from, row_size * sizeof(float)) == 0) continue;
    std::memcpy(to, from, row_size * sizeof(float));
    is_changed = true;
  }
  known.is_old = false;
  known.put = now;
  if (is_changed) known.version = ++version_;
  if (is_first) --missing_;
}

std::uint64_t LiveImage::version() const {
  const std::lock_guard lock(mutex_);
  return missing_ == 0 ? version_ : 0;
}

LiveBytes LiveImage::all() const {
  const std::lock_guard lock(mutex_);
  LiveBytes all{version_, tiles_.size(), {}};
  append(all.bytes, values_.data(), values_.size() * sizeof(float));
  return all;
}

LiveBytes LiveImage::changed_since(std::uint64_t version) const {
  LiveBytes changed{this->version(), 0, {}};
  for (int row = 0; row < grid_.rows; ++row) {
    // Those who write wait for no more than a row of tiles.
    const std::lock_guard lock(mutex_);
    for (int column = 0; column < grid_.columns; ++column) {
      const PixelRect tile = tile_at(window_, tile_size, column, row);
      if (tiles_[number_of(tile)].version <= version) continue;
      ++changed.tiles;
      const std::array<std::uint32_t, 4> head{std::uint32_t(tile.x0 - window_.x0),
                                              std::uint32_t(tile.y0 - window_.y0),
                                              std::uint32_t(tile.width()), std::uint32_t(tile.height())};
      append(changed.bytes, head.data(), sizeof(head));
      for (int y = 0; y < tile.height(); ++y)
        append(changed.bytes, values_.data() + place_of(tile, y),
               std::size_t(tile.width()) * channels_ * sizeof(float));
    }
  }
  return changed;
}

}  // namespace twinray
