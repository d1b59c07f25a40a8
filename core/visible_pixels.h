// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/aabb.h"
#include "core/camera.h"
#include "core/film.h"

namespace twinray {

/// The pixels of which some may be asked for.
struct PicturePixels {
  int width = 0, height = 0;              ///< Of the frame.
  PixelRect window{0, 0, width, height};  ///< Those that are rendered; it may reach beyond the frame.
  Vec2 margin{1, 1};  ///< In pixels: one, and as much as samples may lie beside their pixel.
};

/// The pixels of a window outside of which no camera ray intersects anything in a box: the rectangle around
/// the box's projected corners, with a margin around it. The camera is that of fit_frame(). All pixels, where
/// it is a panorama or has a lens, or where the box is not wholly in front of it; none for an empty box.
PixelRect visible_pixels(const Camera& camera, const Aabb& box, const PicturePixels& pixels);

inline bool contains(const PixelRect& pixels, int x, int y) {
  return x >= pixels.x0 && x < pixels.x1 && y >= pixels.y0 && y < pixels.y1;
}

}  // namespace twinray
