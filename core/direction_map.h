// SPDX-License-Identifier: Apache-2.0
// Pictures whose points are directions: where each lies, and what the picture holds between its pixels. All
// in the picture's own space, and in double, since a map of 16384 columns is finer than a float's turns.
#pragma once
#include "core/image.h"
#include "core/light.h"
#include "core/vec.h"

namespace twinray {

/// A point of a picture: fractions of its width, from the left, and of its height, from the top, in [0, 1].
struct MapPoint {
  double x = 0, y = 0;
};

/// A rectangle of a picture.
struct MapCell {
  MapPoint lower, upper;
};

/// The point of a direction, of any length but 0.
MapPoint map_point(MapLayout layout, const Vec3& direction);
/// The unit direction of a point of the equal-area square, which may lie up to 1 beside it: where the sphere
/// goes on there.
Vec3 wrapped_direction(MapPoint point);
/// What of a point's y counts where directions are chosen: it changes evenly with the solid angle above y.
double map_height(MapLayout layout, double y);
/// A unit direction whose point lies in the cell, uniform by solid angle for u uniform in [0, 1)^2.
Vec3 direction_within(MapLayout layout, const MapCell& cell, Vec2 u);
/// The same of a cell that has heights in place of its y.
Vec3 direction_between(MapLayout layout, const MapCell& heights, Vec2 u);
/// How much of all directions, 4 pi, a cell covers.
double solid_angle(MapLayout layout, const MapCell& cell);

/// The pixel at a position that may lie up to one pixel beside the picture: where the sphere goes on there.
const Rgb& wrapped_pixel(MapLayout layout, const Image& map, int x, int y);
/// Bilinear between the centres of the pixels, and beyond the outermost as they are.
Rgb clamped_value(const Image& picture, MapPoint point);
/// Bilinear between the centres of the pixels, all around.
Rgb map_value(MapLayout layout, const Image& map, MapPoint point);

}  // namespace twinray
