// SPDX-License-Identifier: Apache-2.0
// Ray origins that leave a surface: the only such function, with a derived bound and no epsilon of the
// scene's size.
#pragma once
#include "core/ray.h"
#include "core/surface.h"

namespace twinray {

/// How far from its computed position a ray must start, along the normal of a triangle, so that the canonical
/// test cannot find the triangle again. With u = 2^-24, M the largest coordinate of the triangle and E its
/// largest edge: interpolation and this shift itself are off by at most 6 u M; the test sees each vertex
/// within 7 u of its distance from the origin, at most 7 u E. Both are rounded up to 8.
float triangle_offset(const Vec3& a, const Vec3& b, const Vec3& c);
/// The same for a sphere: its position is off by up to 4 u of |centre| + radius, the test works in double.
float sphere_offset(const Sphere& sphere);

/// The point from which a ray along `direction` leaves the surface: moved to that side of it.
Vec3 leave_surface(const SurfacePoint& point, const Vec3& direction);

/// The ray from a surface along a direction, to infinity.
Ray spawn_ray(const SurfacePoint& from, const Vec3& direction);

/// The connection of two points of surfaces: direction = target - origin, both moved off their surfaces
/// towards each other, and t_max = 1.
Ray connect(const SurfacePoint& from, const SurfacePoint& to);
/// The connection of a surface with a point in space, such as a point light.
Ray connect(const SurfacePoint& from, const Vec3& to);

}  // namespace twinray
