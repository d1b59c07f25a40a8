// SPDX-License-Identifier: Apache-2.0
#include "core/ray_cone.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// Which part of the square root of its solid angle a scattered direction's cone is wide: many paths are
/// averaged, each of which should see less than all of them.
constexpr float part_of_lobe = 0.25f;
/// A cone never widens by more, so that a direction of hardly any density does not see all of the scene.
constexpr float widest = 1;
/// A surface seen at a grazing angle has the footprint of one that is seen under this cosine.
constexpr float least_cosine = 1e-3f;

/// How many units of texture coordinates lie on a unit of length of the surface, on the average over the
/// surface's directions: the square root of the ratio of a triangle's two areas. In the space of its shape.
float own_texture_density(const Geometry& geometry, const Hit& hit, CoordinateSet set) {
  const Mesh* mesh = geometry.mesh(hit.mesh);
  if (!mesh) {  // The octahedral map has the unit square for the whole sphere.
    constexpr float four_pi = 12.566370614f;
    const float radius = geometry.sphere_set(hit.mesh)->spheres[hit.primitive].radius;
    return 1 / (radius * std::sqrt(four_pi));
  }
  const auto& [a, b, c] = mesh->triangles[hit.primitive];
  const Vec3& corner = mesh->positions[a];
  const float area = length(cross(mesh->positions[b] - corner, mesh->positions[c] - corner));
  const auto& [uvs, indices] = uv_set(*mesh, set);
  if (uvs.empty()) return 1 / std::sqrt(area);
  const auto& [i, j, k] = indices[hit.primitive];
  const Vec2 s = uvs[j] - uvs[i], t = uvs[k] - uvs[i];
  return std::sqrt(std::fabs(s.x * t.y - s.y * t.x) / area);
}

/// In the scene, where an instance's matrix A makes |det A| / |A^T n| of an area with the unit normal n
/// there.
float texture_density(const Geometry& geometry, const Hit& hit, const Vec3& normal, CoordinateSet set) {
  const float own = own_texture_density(geometry, hit, set);
  const Transform* const to_world = geometry.to_world(hit.instance);
  if (!to_world) return own;
  const double area = std::fabs(to_world->determinant()) / length(to_world->transposed_vector(normal));
  return own / float(std::sqrt(area));
}

}  // namespace

RayCone RayCone::scattered(float pdf) const {
  return {width, spread + std::min(part_of_lobe / std::sqrt(pdf), widest)};
}

RayCone pixel_cone(const Camera& camera, int width, int height) {
  const float across = 2 * camera.tan_half_width / float(width),
              up = 2 * camera.tan_half_height / float(height);
  const float pixel = std::sqrt(across * up);
  return camera.projection == Projection::orthographic ? RayCone{pixel, 0} : RayCone{0, pixel};
}

float section_width(const SurfacePoint& point, float width, const Vec3& direction) {
  const float cosine = std::fabs(dot(point.geometric_normal, direction)) / length(direction);
  return width / std::sqrt(std::max(cosine, least_cosine));
}

float texture_footprint(const Geometry& geometry, const Hit& hit, const SurfacePoint& point, float width,
                        const Vec3& direction, CoordinateSet set) {
  return section_width(point, width * texture_density(geometry, hit, point.geometric_normal, set), direction);
}

}  // namespace twinray
