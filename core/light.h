// SPDX-License-Identifier: Apache-2.0
// Sources of light, as a scene describes them: plain values. core/light_set.h samples them.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "core/image.h"
#include "core/rgb.h"
#include "core/vec.h"

namespace twinray {

/// Which side of a triangle emits: where its vertices appear counter-clockwise (front), clockwise, or both.
enum class EmissionSide { front, back, both };

/// A mesh, all of whose triangles emit the same radiance in all directions of its side. An area light's
/// rectangle is one of two triangles.
struct MeshLight {
  std::uint32_t shape = 0;  ///< Index into Geometry::shapes(); a mesh.
  Rgb radiance;
  EmissionSide side = EmissionSide::both;
};

/// A sphere that emits the same radiance in all directions, outward.
struct SphereLight {
  std::uint32_t shape = 0;  ///< Index into Geometry::shapes(); a set of one sphere.
  Rgb radiance;
};

/// How the light of a point or spot source falls off with the distance d: 1 / (constant + linear d +
/// quadratic d^2). The default is the physical law, 1 / d^2.
struct Attenuation {
  float constant = 0, linear = 0, quadratic = 1;
};

struct PointLight {
  Vec3 position;
  Rgb intensity;  ///< Radiant intensity (power per solid angle), under the physical law.
  Attenuation attenuation;
};

/// A point light confined to a cone: full strength times cos(angle to the axis)^falloff_exponent inside of
/// it.
struct SpotLight {
  Vec3 position;
  Vec3 direction{0, 0, -1};  ///< The axis, a unit vector along which the light travels.
  Rgb intensity;
  Attenuation attenuation;
  float falloff_angle_degrees = 180;  ///< The whole opening of the cone, in (0, 360].
  float falloff_exponent = 0;         ///< >= 0.
};

/// Light from infinitely far away.
struct DirectionalLight {
  Vec3 direction{0, 0, -1};  ///< The unit vector along which the light travels.
  Rgb irradiance;            ///< On a surface that faces it.
};

/// Constant radiance from the hemisphere around `up`. The camera does not see it.
struct AmbientLight {
  Vec3 up{0, 1, 0};  ///< A unit vector.
  Rgb radiance;
};

/// Light from all around, as a picture: latitude-longitude, the top row towards +y.
struct EnvironmentLight {
  std::shared_ptr<const Image> map;  ///< Never null, at least one pixel, radiance.
};

using LightSource = std::variant<MeshLight, SphereLight, PointLight, SpotLight, DirectionalLight,
                                 AmbientLight, EnvironmentLight>;

struct Light {
  std::string name;
  LightSource source;
};

}  // namespace twinray
