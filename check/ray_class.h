// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace twinray {

/// Where the rays of a crosscheck come from. The first three are those of the scene's own light paths; the
/// others are made from its shapes.
enum class RayClass {
  camera,      ///< From the camera.
  shadow,      ///< Shadow rays, which end exactly on a light.
  bounce,      ///< Scattered from surface to surface.
  random,      ///< Between random points in and around the scene; every other one ends at its second point.
  vertices,    ///< Through vertices.
  edges,       ///< Through points of edges.
  axes,        ///< Along an axis, the other components 0 or -0, through vertices and middles of edges.
  box_faces,   ///< Within a face of a triangle's box.
  grazing,     ///< Nearly or exactly in a triangle's plane.
  surface,     ///< From a point on a triangle, in any direction.
  ends,        ///< t_min or t_max exactly at a hit, or one float beside it.
  directions,  ///< Directions of any length that a float can have.
  far,         ///< From up to 10^7 scene sizes away.
  moved,       ///< The scene moved to 10^5 times its size; rays of some classes above.
  shrunk,      ///< The scene scaled by 10^-6.
  grown        ///< The scene scaled by 10^6, or as far as coordinates may go.
};
inline constexpr std::size_t ray_class_count = 16;

/// "camera", "box faces", ...
std::string ray_class_name(RayClass ray_class);

/// How a geometry is moved and scaled for a crosscheck.
enum class Placement { file, moved, shrunk, grown };

/// file, but for the last three classes.
Placement placement_of(RayClass ray_class);
/// "file", "moved", "shrunk", "grown"; parse throws Error that lists them.
std::string placement_name(Placement placement);
Placement parse_placement(const std::string& name);

}  // namespace twinray
