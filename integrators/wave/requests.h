// SPDX-License-Identifier: Apache-2.0
// Private: what the stages of a wave are asked for.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/camera.h"
#include "core/light.h"
#include "core/light_patch.h"
#include "core/light_set.h"
#include "core/sampler.h"
#include "integrators/wave/columns.h"

namespace twinray {

/// Which draws: draw_pair.
struct DrawRequest {
  SamplerKind kind = SamplerKind::sobol;
  DrawPlace place;
  SubSample sub;
};

/// A camera without a lens whose rays start at one point, and its frame in pixels.
struct PinholeRequest {
  const Camera& camera;
  int width = 0, height = 0;
};

/// A mesh light, as far as the arithmetic of its samples needs it.
struct MeshLightRequest {
  Rgb radiance;
  EmissionSide side = EmissionSide::both;
  double area = 0;
};

/// A sphere light likewise.
struct SphereLightRequest {
  Rgb radiance;
  Vec3 center;
  float radius = 0;
  float offset = 0;  ///< sphere_offset.

  double squared_radius() const { return double(radius) * radius; }
};

/// Where and how light samples are weighted by multiple importance sampling.
struct MisRequest {
  Zone zone;               ///< At Lambert surfaces; none: not at all.
  bool is_shared = false;  ///< At other surfaces: everywhere.
  float count = 1;         ///< Of the light's samples.
};

/// The draws of a direction at each of the wave's surfaces.
struct DirectionDraws {
  const Floats &lobe, &ux, &uy;
};

/// A triangle of a light, as points of it are made.
struct PatchTriangle {
  Vec3 a, b, c, normal;
  float offset = 0;
};

/// A light of a group, as each lane fetches its own: a mesh of one patch that emits evenly.
struct Lamp {
  Vec3 corners[4];
  Vec3 normal;
  float share = 0;  ///< LightPatch::share; 0: the light is another one, which lanes do not know.
  Rgb radiance;
  PatchTriangle triangles[2];
  std::uint32_t second_corner[2], third_corner[2];  ///< LightPatch::corner_of, of either triangle.
  std::uint32_t is_parallelogram = 0;
  std::uint32_t side = 0;                     ///< An EmissionSide.
  std::uint32_t area_low = 0, area_high = 0;  ///< The halves of a double.
};

/// A mesh light of few patches, with the two triangles of each.
struct PatchTable {
  const PatchLight* light = nullptr;  ///< Null: the light is no mesh, or has more.
  PatchTriangle triangles[PatchLight::most][2];
};

}  // namespace twinray
