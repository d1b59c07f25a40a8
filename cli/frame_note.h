// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "core/camera.h"
#include "core/geometry.h"

namespace twinray {

/// How much of the geometry lies in a camera's view, whatever stands in front of it.
enum class InView { nothing, part, whole };

/// Of the triangles and spheres themselves, not of their boxes. A sphere near a corner of the view may count
/// as seen in part where it is not seen. Empty geometry is seen as a whole, and by
/// a panorama all of it.
InView in_view(const Camera& camera, const Geometry& geometry);

/// What to tell of a picture by this camera; empty where all of the geometry is in view.
std::string frame_note(const Camera& camera, const Geometry& geometry);

}  // namespace twinray
