// SPDX-License-Identifier: Apache-2.0
// Functions on the unit square by their values at the nodes of a grid, bilinear between them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/vec.h"

namespace twinray {

/// Which slices of a table are blended, in what proportion.
struct SliceBlend {
  static constexpr std::size_t most = 4;
  std::array<std::uint32_t, most> slices{};
  std::array<double, most> weights{1};
  std::size_t count = 1;
};

/// Slices of one size, each a function on the unit square. Of the nodes x runs fastest, then y, then the
/// slice; the square's corners are nodes.
template <typename Value>
class SquareTable {
 public:
  /// Throws Error unless there are at least two nodes along each axis, and the values of one slice or more.
  SquareTable(std::size_t width, std::size_t height, std::vector<Value> values)
      : width_(width), height_(height), values_(std::move(values)) {
    if (width < 2 || height < 2) throw Error("a table needs two rows and two columns at least");
    if (values_.empty() || values_.size() % (width * height) != 0)
      throw Error("a table needs a number for each of its nodes");
  }

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  std::size_t slices() const { return values_.size() / (width_ * height_); }
  const std::vector<Value>& values() const { return values_; }
  const Value& node(std::size_t slice, std::size_t x, std::size_t y) const {
    return values_[(slice * height_ + y) * width_ + x];
  }

  /// A point's cell, by its lower corner, and where in it the point lies, both in [0, 1].
  struct Place {
    std::size_t x, y;
    Vec2 within;
  };
  /// Of a point in the unit square.
  Place place(Vec2 point) const {
    const Vec2 scaled{point.x * float(width_ - 1), point.y * float(height_ - 1)};
    const std::size_t x = std::min(std::size_t(scaled.x), width_ - 2);
    const std::size_t y = std::min(std::size_t(scaled.y), height_ - 2);
    return {x, y, {scaled.x - float(x), scaled.y - float(y)}};
  }
  Value at(Vec2 point, const SliceBlend& blend = {}) const {
    const Place cell = place(point);
    const Vec2 within = cell.within;
    Value sum{};
    for (std::size_t i = 0; i < blend.count; ++i) {
      const auto row = [&](std::size_t y) {
        return node(blend.slices[i], cell.x, y) * (1 - within.x) +
               node(blend.slices[i], cell.x + 1, y) * within.x;
      };
      sum += (row(cell.y) * (1 - within.y) + row(cell.y + 1) * within.y) * float(blend.weights[i]);
    }
    return sum;
  }

 private:
  std::size_t width_, height_;
  std::vector<Value> values_;
};

}  // namespace twinray
