// SPDX-License-Identifier: Apache-2.0
// Spheres, disks, cylinders and bilinear patches cut into triangles, finely enough for a picture: 256 edges
// around. An inscribed circle of so many edges lacks 10^-4 of its area. Their fronts and texture coordinates
// are pbrt's.
#pragma once
#include <array>

#include "core/geometry.h"

namespace twinray {

/// Part of a sphere about the origin: z in [z_min, z_max], angles about z from +x up to phi_max.
struct PartialSphere {
  float radius = 1, z_min = -1, z_max = 1, phi_max_degrees = 360;
};
/// A ring in the plane z = height; its front looks towards +z.
struct Disk {
  float height = 0, radius = 1, inner_radius = 0, phi_max_degrees = 360;
};
/// A cylinder about the z axis; its front looks outward.
struct Cylinder {
  float radius = 1, z_min = -1, z_max = 1, phi_max_degrees = 360;
};

Mesh sphere_mesh(const PartialSphere& sphere);
Mesh disk_mesh(const Disk& disk);
Mesh cylinder_mesh(const Cylinder& cylinder);

/// Adds a bilinear patch to a mesh, whose normals and uvs are those of its positions: indices of the corners
/// (0, 0), (1, 0), (0, 1), (1, 1). A parallelogram becomes two triangles if its normals and uvs go evenly
/// over it, all else is cut finely.
void add_bilinear_patch(const std::array<std::uint32_t, 4>& corners, Mesh& mesh);

}  // namespace twinray
