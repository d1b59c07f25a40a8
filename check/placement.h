// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "check/ray_class.h"
#include "core/geometry.h"

namespace twinray {

/// The shapes at another place or size, without normals and texture coordinates: moved by 10^5 times its
/// size, scaled by 10^-6 or 10^6 (the latter two about the origin of coordinates). Less far where
/// max_coordinate would be passed. Triangles that lose their area are dropped, so primitives may have other
/// numbers. `file` gives the geometry itself.
std::shared_ptr<const Geometry> placed_geometry(const std::shared_ptr<const Geometry>& geometry,
                                                Placement placement);

}  // namespace twinray
