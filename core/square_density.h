// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/square_table.h"

namespace twinray {

/// Densities on the unit square, one for each slice of a table, and points sampled by a blend of them: a row
/// by the integrals of all rows, then a place along it. A blend is of the slices' densities, each of which
/// integrates to 1. (The warps of Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material
/// Acquisition and Rendering", 2018.)
class SquareDensity {
 public:
  /// In proportion to a table's numbers. A slice of zeros, or of less than 1e-30, has the same density
  /// everywhere. Throws Error where a number is negative or not finite, or all are too large to be summed up.
  explicit SquareDensity(const SquareTable<float>& table);

  const SquareTable<float>& table() const { return table_; }

  struct Sample {
    Vec2 point;
    float pdf = 0;  ///< Per area of the square.
  };
  /// Where a uniform point u of the unit square is taken to.
  Sample sample(Vec2 u, const SliceBlend& blend) const;
  /// The u that sample() takes to a point, but for rounding, and the density at the point.
  Sample invert(Vec2 point, const SliceBlend& blend) const;
  float pdf(Vec2 point, const SliceBlend& blend) const;

 private:
  /// With each slice's weight over its integral.
  SliceBlend normalized(const SliceBlend& blend) const;
  /// On a line of nodes across the row of cells y.
  double value(const SliceBlend& blend, std::size_t x, std::size_t y, double within_y) const;
  /// Integrals, in units of a cell: over the rows of cells before y, along a line of nodes up to x, and along
  /// all of it.
  double before_row(const SliceBlend& blend, std::size_t y) const;
  double before_node(const SliceBlend& blend, std::size_t x, std::size_t y) const;
  double on_line(const SliceBlend& blend, std::size_t y) const;
  float pdf_of(double value) const;

  SquareTable<float> table_;
  std::vector<float> lines_;     ///< Of each node, the integral along its line of nodes up to it.
  std::vector<float> rows_;      ///< Of each line, the integral over the rows of cells before it.
  std::vector<double> weights_;  ///< Of each slice, 1 over its integral.
};

}  // namespace twinray
