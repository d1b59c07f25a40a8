// SPDX-License-Identifier: Apache-2.0
// Private: the planes at which the boxes of a compact node may end, across one axis.
#pragma once
#include <span>

namespace twinray {

/// From where to where a child's box reaches across an axis.
struct Extent {
  float lower, upper;
};

/// Equidistant planes, counted from 0 to most_steps.
struct Grid {
  static constexpr int most_steps = 255;

  float origin, step;

  /// A product and a sum, both rounded: no smaller for more steps.
  float plane(int steps) const { return float(steps) * step + origin; }
  /// The last plane that is not above `at`, and the first that is not below it. One must be there.
  int last_below(float at) const;
  int first_above(float at) const;
};

/// A grid that reaches from the lowest to the highest plane of some children, of which there is at least one;
/// their planes are finite.
///
/// A flat child, thinner than a step, becomes a step thick, and rays begin on what it holds: each that leaves
/// a wall of a room on the side of the added thickness would visit the wall's leaf. So the grid has a plane
/// where the lowest flat child ends, and one where the highest begins: the thickness is added outside.
Grid fit_grid(std::span<const Extent> children);

}  // namespace twinray
