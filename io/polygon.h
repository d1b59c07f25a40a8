// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace twinray {

/// Cuts a polygon of three or more corners into triangles (indices into `corners`) of the same winding: a fan
/// where it is convex, ears otherwise (Meisters, "Polygons Have Ears", 1975). It need not be quite flat: it
/// is seen along its mean normal. One that crosses itself is cut somehow, into triangles of its corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

/// The most corners that a polygon may have, because finding ears takes cubic time.
inline constexpr std::size_t max_polygon_corners = 1000;

}  // namespace twinray
