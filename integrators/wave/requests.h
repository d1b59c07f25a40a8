// SPDX-License-Identifier: Apache-2.0
// Private: what the stages of a wave are asked for.
#pragma once
#include <cstdint>

#include "core/light.h"
#include "core/sampler.h"

namespace twinray {

/// Which draw of a vertex: VertexSampler::draw_2d.
struct DrawRequest {
  SamplerKind kind = SamplerKind::sobol;
  Purpose purpose = Purpose::light_point;
  std::uint32_t part = 0, parts = 1, stream = 0;
};

/// A mesh light, as far as the arithmetic of its samples needs it.
struct MeshLightRequest {
  Rgb radiance;
  EmissionSide side = EmissionSide::both;
  double area = 0;
};

}  // namespace twinray
