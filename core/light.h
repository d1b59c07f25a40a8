// SPDX-License-Identifier: Apache-2.0
// Sources of light, as a scene describes them: plain values. core/light_set.h samples them.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "core/image.h"
#include "core/rgb.h"
#include "core/texture.h"
#include "core/transform.h"
#include "core/vec.h"

namespace twinray {

/// Which side of a triangle emits: where its vertices appear counter-clockwise (front), clockwise, or both.
enum class EmissionSide { front, back, both };

/// A mesh, all of whose triangles emit the same radiance in all directions of its side; with a picture, one
/// that differs from point to point. An area light's rectangle is one of two triangles.
struct MeshLight {
  std::uint32_t shape = 0;  ///< Index into Geometry::shapes(); a mesh.
  Rgb radiance;             ///< Times the picture, if there is one.
  EmissionSide side = EmissionSide::both;
  /// Over the texture coordinates, as an ImageTexture's. Null: even; else at least one pixel, all finite.
  /// What a surface shows is made no less than 0: a channel of a pixel that completes a triangle's plane,
  /// beyond the triangle, may be negative, its luminance is not.
  std::shared_ptr<const Image> picture = nullptr;
  UvTransform uv = {};
  Wrap wrap = WrapMode::clamp;
  TextureFilter filter = TextureFilter::bilinear;  ///< Or nearest.
};

/// The radiance of a mesh light, on the average over its picture.
inline Rgb mean_radiance(const MeshLight& light) {
  return light.picture ? light.radiance * mean_of(*light.picture) : light.radiance;
}

inline bool emits(const MeshLight& light) { return !is_black(mean_radiance(light)); }

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
/// it; within the penumbra, along the cone's edge, it falls smoothly to none.
struct SpotLight {
  Vec3 position;
  Vec3 direction{0, 0, -1};  ///< The axis, a unit vector along which the light travels.
  Rgb intensity;
  Attenuation attenuation;
  float falloff_angle_degrees = 180;  ///< The whole opening of the cone, in (0, 360].
  float falloff_exponent = 0;         ///< >= 0.
  float penumbra_degrees = 0;         ///< How wide; in [0, half of the opening]. pbrt's conedeltaangle.
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

/// How the points of a picture are directions, in the picture's own space.
enum class MapLayout {
  /// Rows from +y to -y, columns once around: with p = atan2(-z, x) in turns, column (p + 1/2) mod 1 of the
  /// width, as CS184's program has it.
  latitude_longitude,
  /// A square around +z, x to the right and y downwards, whose four corners are -z: every pixel covers the
  /// same solid angle (Clarberg 2008). pbrt-v4's environments are such pictures.
  equal_area,
};

/// Light from all around, as a picture. The camera sees it. A picture of one pixel is a constant sky.
struct EnvironmentLight {
  std::shared_ptr<const Image> map;  ///< Never null, at least one pixel, radiance. A square if equal_area.
  MapLayout layout = MapLayout::latitude_longitude;
  Transform rotation;  ///< From the picture's space to the world; may mirror. It does not translate.
  Rgb scale{1, 1, 1};  ///< Times the picture's radiance; finite and >= 0.
};

/// A point light whose strength in each direction is a picture's, by the physical law.
struct GoniometricLight {
  Vec3 position;
  Rgb intensity;                     ///< Times the picture.
  std::shared_ptr<const Image> map;  ///< As an environment's; the direction is that in which light travels.
  MapLayout layout = MapLayout::equal_area;
  Transform rotation;  ///< As an environment's.
};

/// A point light that throws a picture, by the physical law: its frame lies as a camera's at the same place.
struct ProjectionLight {
  Vec3 position;
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  ///< Unit vectors at right angles.
  float tan_half_width = 1, tan_half_height = 1;        ///< Of the frame's angles; > 0.
  Rgb intensity;                                        ///< Times the picture.
  std::shared_ptr<const Image> picture;                 ///< Never null, at least one pixel.
};

/// A disc of constant radiance infinitely far away. The camera sees it.
struct SunLight {
  Vec3 direction{0, 0, -1};        ///< The unit vector along which the light of its centre travels.
  Rgb irradiance;                  ///< On a surface that faces it.
  float diameter_degrees = 0.53f;  ///< The angle under which it is seen; in (0, 180).
};

using LightSource = std::variant<MeshLight, SphereLight, PointLight, SpotLight, DirectionalLight,
                                 AmbientLight, EnvironmentLight, GoniometricLight, ProjectionLight, SunLight>;

/// Whether a source is a point or a direction, which no ray can hit by chance: one sample is exact.
inline bool is_delta(const LightSource& source) {
  return std::holds_alternative<PointLight>(source) || std::holds_alternative<SpotLight>(source) ||
         std::holds_alternative<GoniometricLight>(source) ||
         std::holds_alternative<ProjectionLight>(source) || std::holds_alternative<DirectionalLight>(source);
}
/// Whether a ray that leaves the scene may find the source.
inline bool is_distant(const LightSource& source) {
  return std::holds_alternative<AmbientLight>(source) || std::holds_alternative<EnvironmentLight>(source) ||
         std::holds_alternative<SunLight>(source);
}
/// Whether a ray of the camera's that leaves the scene sees the source.
inline bool is_background(const LightSource& source) {
  return std::holds_alternative<EnvironmentLight>(source) || std::holds_alternative<SunLight>(source);
}

struct Light {
  std::string name;
  LightSource source;
  std::uint32_t group = 0;  ///< Index into Scene::light_groups, if the scene has any.
};

}  // namespace twinray
