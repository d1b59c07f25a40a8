// SPDX-License-Identifier: Apache-2.0
// Private: what the stages of a wave are asked for.
#pragma once
#include <cstddef>
#include <cstdint>

#include "core/light.h"
#include "core/sampler.h"

namespace twinray {

/// Which draws: draw_pair.
struct DrawRequest {
  SamplerKind kind = SamplerKind::sobol;
  DrawPlace place;
  SubSample sub;
};

/// A mesh light, as far as the arithmetic of its samples needs it.
struct MeshLightRequest {
  Rgb radiance;
  EmissionSide side = EmissionSide::both;
  double area = 0;
};

/// The triangles of a mesh light that has few: a rectangle's two, mostly. The sums are those of its
/// Distribution by area.
struct FewTriangles {
  static constexpr std::size_t most = 4;
  std::size_t size = 0;     ///< 0: the light is no mesh, or has more.
  std::size_t last = 0;     ///< The last one that has area.
  double sums[most + 1]{};  ///< Of the areas before each.
  Vec3 a[most], b[most], c[most], normal[most];
  float offset[most]{};
};

}  // namespace twinray
