// SPDX-License-Identifier: Apache-2.0
#include "accel/compact/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinray {
namespace {

/// From this step on, fitted steps and what they are rounded by are normal floats.
constexpr double min_fitted_step = 0x1p-100;

Extent extent_of_all(std::span<const Extent> children) {
  Extent all = children[0];
  for (const Extent& child : children)
    all = {std::min(all.lower, child.lower), std::max(all.upper, child.upper)};
  return all;
}

double length(const Extent& extent) { return double(extent.upper) - double(extent.lower); }

bool reaches(const Grid& grid, const Extent& all) {
  return grid.plane(0) <= all.lower && grid.plane(Grid::most_steps) >= all.upper;
}

/// The finest grid from the lower end on.
Grid finest_grid(const Extent& all) {
  Grid grid{all.lower, std::max(float(length(all) / Grid::most_steps), std::numeric_limits<float>::min())};
  while (!reaches(grid, all)) grid.step = std::nextafter(grid.step, std::numeric_limits<float>::infinity());
  return grid;
}

/// The part of a node that should begin and end at planes of its grid: from the end of the lowest flat child
/// to the beginning of the highest, or to the node's own ends where there is none in that half.
Extent part_between_flats(std::span<const Extent> children, const Extent& all, float thickness) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float first_end = infinity, last_begin = -infinity;
  for (const Extent& child : children) {
    if (length(child) >= thickness) continue;
    first_end = std::min(first_end, child.upper);
    last_begin = std::max(last_begin, child.lower);
  }
  const double middle = 0.5 * (double(all.lower) + double(all.upper));
  return {first_end < middle ? first_end : all.lower, last_begin > middle ? last_begin : all.upper};
}

/// A grid with planes at the ends of a part, or at most a rounding within it. False where rounding does not
/// let it be.
bool fit_to_part(const Extent& all, const Extent& part, Grid& grid) {
  const double least_step = length(all) / (Grid::most_steps - 2);  // Both ends may take a step more.
  const int first = int(std::ceil((double(part.lower) - double(all.lower)) / least_step));
  const int last = first + int(length(part) / least_step);
  if (last == first) return false;
  const double rounding = std::max(std::abs(all.lower), std::abs(all.upper)) * 0x1p-23;
  int lower_moves = 0, upper_moves = 0;
  while (lower_moves + upper_moves < 8) {
    const double lower = part.lower + lower_moves * rounding, upper = part.upper - upper_moves * rounding;
    const double step = (upper - lower) / (last - first);
    grid = {float(lower - first * step), float(step)};
    if (grid.plane(first) < part.lower)
      ++lower_moves;
    else if (grid.plane(last) > part.upper)
      ++upper_moves;
    else
      return reaches(grid, all);
  }
  return false;
}

/// How many steps a plane may be moved down to from above, or up to from below.
int steps_near(const Grid& grid, float at) {
  return std::clamp(int((double(at) - grid.origin) / grid.step), 0, Grid::most_steps);
}

}  // namespace

int Grid::last_below(float at) const {
  int steps = steps_near(*this, at);
  while (steps < most_steps && plane(steps + 1) <= at) ++steps;
  while (plane(steps) > at) --steps;
  return steps;
}

int Grid::first_above(float at) const {
  int steps = steps_near(*this, at);
  while (steps > 0 && plane(steps - 1) >= at) --steps;
  while (plane(steps) < at) ++steps;
  return steps;
}

Grid fit_grid(std::span<const Extent> children) {
  const Extent all = extent_of_all(children);
  const Grid finest = finest_grid(all);
  const Extent part = part_between_flats(children, all, finest.step);
  const bool has_flats = part.lower != all.lower || part.upper != all.upper;
  Grid fitted;
  return has_flats && finest.step >= min_fitted_step && fit_to_part(all, part, fitted) ? fitted : finest;
}

}  // namespace twinray
