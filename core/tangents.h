// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "core/geometry.h"
#include "core/surface.h"

namespace twinray {

/// How a surface's points move with its texture coordinates: dp/du and dp/dv, neither zero nor parallel.
struct Tangents {
  Vec3 du, dv;
};

/// At a point that surface_at() gave. None where texture coordinates do not tell: a mesh without any, a
/// triangle whose coordinates lie on a line. Of a sphere those of its octahedral coordinates.
std::optional<Tangents> tangents_at(const Geometry& geometry, const SurfacePoint& point);

}  // namespace twinray
