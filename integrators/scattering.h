// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "integrators/direct_light.h"
#include "integrators/interaction.h"

namespace twinray {

/// What kind of scattering it is: a diffuse or a glossy reflection, a mirror's among the latter, or the way
/// through the surface or a medium.
enum class ScatterKind : std::uint32_t { diffuse, glossy, transmission };

/// How a path goes on from a surface.
struct Scattering {
  Vec3 direction;  ///< Unit, in world space.
  Rgb throughput;  ///< Of the path, behind the surface; not black.
  Departure departure;
  Interiors interiors;  ///< That it is in there.
  float eta = 1;  ///< Index of refraction behind the surface, to that before it; 1 where light is reflected.
  ScatterKind kind = ScatterKind::diffuse;
  bool is_below = false;  ///< It goes below the surface, into the body there (integrators/walk_below.h).
};

/// Chooses a direction by the scattering function there; none where the path ends. `lobe` in [0, 1), u in
/// [0, 1)^2.
std::optional<Scattering> scatter(const Interaction& at, const Rgb& throughput, float lobe, Vec2 u);

}  // namespace twinray
