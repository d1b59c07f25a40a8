// SPDX-License-Identifier: Apache-2.0
#include "core/point_light.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/direction_map.h"
#include "core/elementary.h"
#include "core/radiance.h"
#include "core/spawn_ray.h"

namespace twinray {
namespace {

double cos_degrees(double degrees) { return cos_radians(degrees * radians_per_degree); }

float falloff(const Attenuation& a, float distance) {
  return 1 / (a.constant + a.linear * distance + a.quadratic * distance * distance);
}

template <typename Source>
LightSample from_point(const Source& light, const Attenuation& attenuation, const SurfacePoint& surface) {
  const Vec3 towards = light.position - surface.position;
  const float squared = length_squared(towards);
  if (!(squared > 0) || !std::isfinite(squared)) return {};
  const float distance = std::sqrt(squared);
  const Vec3 direction = towards / distance;
  const Rgb irradiance = intensity_along(light, -direction) * falloff(attenuation, distance);
  if (is_black(irradiance)) return {};
  return {direction, irradiance, 1, connect(surface, light.position)};
}

/// From 1 where the cosine is that of the penumbra's inner edge to 0 where it is that of the cone's.
float smooth_edge(const SpotLight& light, double cosine, double cone) {
  if (light.penumbra_degrees == 0) return 1;
  const double inner = cos_degrees(0.5 * light.falloff_angle_degrees - light.penumbra_degrees);
  const double t = std::min((cosine - cone) / (inner - cone), 1.0);
  return float(t * t * (3 - 2 * t));
}

/// The factor of intensities where light falls off as factor / d^2; 0 where it falls off otherwise.
double physical_part(const Attenuation& a) {
  return a.constant == 0 && a.linear == 0 && a.quadratic > 0 ? 1 / double(a.quadratic) : 0;
}

/// The integral of cosine^exponent from one cosine to 1, without those below 0 if there is an exponent.
double integral_from(double cosine, double exponent) {
  if (!(exponent > 0)) return 1 - cosine;
  return (1 - pow_of(std::max(cosine, 0.0), exponent + 1)) / (exponent + 1);
}

/// The same of the whole strength, along the cone's edge.
double edge_integral(const SpotLight& light, double cone, double inner) {
  constexpr int steps = 256;
  const double step = (inner - cone) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double begin = cone + step * i;
    const double here =
        integral_from(begin, light.falloff_exponent) - integral_from(begin + step, light.falloff_exponent);
    sum += here * double(smooth_edge(light, begin + step / 2, cone));
  }
  return sum;
}

}  // namespace

Rgb power_of(const PointLight& light) {
  return light.intensity * float(4 * pi_double * physical_part(light.attenuation));
}

Rgb power_of(const SpotLight& light) {
  const double half = 0.5 * light.falloff_angle_degrees;
  const double cone = cos_degrees(half), inner = cos_degrees(half - light.penumbra_degrees);
  const double solid = integral_from(inner, light.falloff_exponent) + edge_integral(light, cone, inner);
  return light.intensity * float(2 * pi_double * solid * physical_part(light.attenuation));
}

Rgb intensity_along(const PointLight& light, const Vec3&) { return light.intensity; }

Rgb intensity_along(const SpotLight& light, const Vec3& direction) {
  const double cosine = dot(light.direction, direction);
  const double cone = cos_degrees(0.5 * light.falloff_angle_degrees);
  if (cosine < cone) return {};
  const Rgb within = light.intensity * smooth_edge(light, cosine, cone);
  if (!(light.falloff_exponent > 0)) return within;
  return within * float(pow_of(std::max(cosine, 0.0), light.falloff_exponent));
}

Rgb intensity_along(const GoniometricLight& light, const Vec3& direction) {
  const MapPoint point = map_point(light.layout, light.rotation.transposed_vector(direction));
  return light.intensity * map_value(light.layout, *light.map, point);
}

Rgb intensity_along(const ProjectionLight& light, const Vec3& direction) {
  const float depth = dot(light.forward, direction);
  if (!(depth > 0)) return {};
  const float x = dot(light.right, direction) / (depth * light.tan_half_width);
  const float y = dot(light.up, direction) / (depth * light.tan_half_height);
  if (!(std::fabs(x) <= 1 && std::fabs(y) <= 1)) return {};
  return light.intensity * clamped_value(*light.picture, {0.5 + 0.5 * double(x), 0.5 - 0.5 * double(y)});
}

LightSample light_from(const PointLight& light, const SurfacePoint& surface) {
  return from_point(light, light.attenuation, surface);
}
LightSample light_from(const SpotLight& light, const SurfacePoint& surface) {
  return from_point(light, light.attenuation, surface);
}
LightSample light_from(const GoniometricLight& light, const SurfacePoint& surface) {
  return from_point(light, {}, surface);
}
LightSample light_from(const ProjectionLight& light, const SurfacePoint& surface) {
  return from_point(light, {}, surface);
}

}  // namespace twinray
