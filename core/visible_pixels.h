// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/aabb.h"
#include "core/camera.h"
#include "core/film.h"

namespace twinray {

/// The pixels of a picture of width x height outside of which no camera ray intersects anything in a box: the
/// rectangle around the box's projected corners, with a margin around it, in pixels: one pixel and as much as
/// samples may lie beside their pixel. The camera is that of fit_frame(). All pixels, where it is a panorama
/// or has a lens, or where the box is not wholly in front of it; none for an empty box.
PixelRect visible_pixels(const Camera& camera, const Aabb& box, int width, int height, Vec2 margin = {1, 1});

inline bool contains(const PixelRect& pixels, int x, int y) {
  return x >= pixels.x0 && x < pixels.x1 && y >= pixels.y0 && y < pixels.y1;
}

}  // namespace twinray
