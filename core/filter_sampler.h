// SPDX-License-Identifier: Apache-2.0
// A sample belongs to one pixel alone: it is placed with the density of the pixel's filter, so that the plain
// mean of a pixel's samples is the filtered picture, and films can be split and merged (Ernst, Stamminger and
// Greiner, "Filter Importance Sampling", 2006).
#pragma once
#include <array>
#include <cstddef>

#include "core/pixel_filter.h"

namespace twinray {

/// Places samples in a pixel with the density |f| / integral of |f|; where f is negative, so is the weight:
/// the mean of weight times light is that filtered by f.
class FilterSampler {
 public:
  static constexpr std::size_t steps = 512;
  /// A stretch of one half of the axis along which the filter keeps its sign. Number i of `quantiles` is
  /// where a part of 1 - (1 - i / steps)^2 of the lobe's integral lies further in: they are close where
  /// filters end. What lies between two of them is taken to be spread evenly in i.
  struct Lobe {
    float share;  ///< Of the integral of |f|.
    std::array<float, steps + 1> quantiles{};

    /// Up to where a part t of the integral lies.
    float at(float t) const;
  };
  /// One axis. A filter without negative values has no outer lobe.
  struct Axis {
    Axis(const PixelFilter& filter, double end);
    float sample(float u, float& weight) const;

    bool is_box;
    float radius;
    float total = 1;  ///< The integral of |f| over that of f.
    Lobe inner{1}, outer{0};
  };

  /// Throws Error for a radius or a parameter out of range.
  explicit FilterSampler(const PixelFilter& filter);

  struct Place {
    Vec2 in_pixel;  ///< (0, 0) is the pixel's top left, (1, 1) its bottom right; it may lie beside it.
    float weight;   ///< +- the integral of |f| over that of f.
  };
  /// Of a point of [0, 1)^2; each coordinate of the place grows with its own.
  Place place(Vec2 u) const;
  const Axis& x() const { return x_; }
  const Axis& y() const { return y_; }

 private:
  Axis x_, y_;
};

}  // namespace twinray
