// SPDX-License-Identifier: Apache-2.0
#include "core/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/mesh_area.h"

namespace twinray {
namespace {

LightBounds at_point(const Vec3& position, double power, const EmissionCone& cone = {}) {
  LightBounds bounds;
  bounds.box.extend(position);
  bounds.power = power;
  bounds.cone = cone;
  return bounds;
}

double mean_luminance(const Image& picture) {
  double sum = 0;
  for (const Rgb& pixel : picture.pixels) sum += double(luminance(pixel));
  return sum / double(picture.pixels.size());
}

/// The cone around the normals of a mesh's fronts.
EmissionCone cone_of_fronts(const Mesh& mesh) {
  constexpr double all_around = pi_double;
  EmissionCone around;
  bool is_first = true;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 normal = cross(mesh.positions[triangle[1]] - mesh.positions[triangle[0]],
                              mesh.positions[triangle[2]] - mesh.positions[triangle[0]]);
    const float size = length(normal);
    if (!(size > 0) || !std::isfinite(size)) continue;
    const EmissionCone one{normal / size, 0};
    around = is_first ? one : together(around, one);
    is_first = false;
    if (around.normals >= all_around) return around;
  }
  return around;
}

struct BoundsOf {
  const Geometry& geometry;

  LightBounds operator()(const MeshLight& light) const {
    const Mesh& mesh = *geometry.mesh(light.shape);
    LightBounds bounds;
    double area = 0;
    for (const Triangle& triangle : mesh.triangles) {
      area += area_vector(mesh, triangle).area();
      for (const std::uint32_t corner : triangle) bounds.box.extend(mesh.positions[corner]);
    }
    const double sides = light.side == EmissionSide::both ? 2 : 1;
    bounds.power = sides * pi_double * area * double(luminance(mean_radiance(light)));
    if (light.side != EmissionSide::both) bounds.cone = cone_of_fronts(mesh);
    if (light.side == EmissionSide::back) bounds.cone.axis = -bounds.cone.axis;
    return bounds;
  }
  LightBounds operator()(const SphereLight& light) const {
    const Sphere& sphere = geometry.sphere_set(light.shape)->spheres[0];
    LightBounds bounds;
    const Vec3 corner{sphere.radius, sphere.radius, sphere.radius};
    bounds.box.extend(sphere.center - corner);
    bounds.box.extend(sphere.center + corner);
    bounds.power = 4 * pi_double * pi_double * double(sphere.radius) * double(sphere.radius) *
                   double(luminance(light.radiance));
    return bounds;
  }
  LightBounds operator()(const PointLight& light) const {
    return at_point(light.position, 4 * pi_double * double(luminance(light.intensity)));
  }
  LightBounds operator()(const SpotLight& light) const {
    const double half = double(light.falloff_angle_degrees) * pi_double / 360;
    return at_point(light.position,
                    2 * pi_double * (1 - cos_radians(half)) * double(luminance(light.intensity)),
                    {light.direction, half, 0});
  }
  LightBounds operator()(const GoniometricLight& light) const {
    return at_point(light.position,
                    4 * pi_double * mean_luminance(*light.map) * double(luminance(light.intensity)));
  }
  LightBounds operator()(const ProjectionLight& light) const {
    const double w = light.tan_half_width, h = light.tan_half_height;
    const double half = 2 * pi_double * atan2_turns(std::sqrt(w * w + h * h), 1);
    const double power = 2 * pi_double * (1 - cos_radians(half)) * mean_luminance(*light.picture) *
                         double(luminance(light.intensity));
    return at_point(light.position, power, {light.forward, half, 0});
  }
  template <typename Distant>
  LightBounds operator()(const Distant&) const {
    return {};
  }
};

}  // namespace

LightBounds bounds_of(const LightSource& source, const Geometry& geometry) {
  return std::visit(BoundsOf{geometry}, source);
}

}  // namespace twinray
