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
///
/// It may have holes: `hole_starts` says where in `corners` each begins, behind the outline; all have three
/// corners or more, in either winding. A bridge joins each to the outline (Eberly, "Triangulation by Ear
/// Clipping", 2002). A hole that does not lie within the outline is left out.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners,
                                                      std::span<const std::size_t> hole_starts = {});

/// The most corners that a polygon may have, because finding ears takes quadratic time.
inline constexpr std::size_t max_polygon_corners = 10'000;

}  // namespace twinray
