// SPDX-License-Identifier: Apache-2.0
// One bounce of light: estimators of the light that lamps send to a surface and that it scatters to the
// viewer.
#pragma once
#include <cstdint>

#include "core/light_set.h"
#include "core/sampler.h"
#include "integrators/interaction.h"
#include "integrators/tracer.h"

namespace twinray {

enum class DirectMethod {
  lights,      ///< Points of the lights are sampled.
  hemisphere,  ///< Directions are sampled, uniformly; what they happen to meet counts. Never meets a delta
               ///< light.
};

/// Everything a light estimate needs besides the point: constant while a scene is rendered.
struct LightTransport {
  const Scene& scene;
  const LightSet& lights;
  DirectMethod method = DirectMethod::lights;
  std::uint32_t samples_per_light = 1;  ///< For each light that is not a delta light; >= 1.
};

/// Unbiased for the light of all lamps, scattered once at the interaction; for `hemisphere`, of all but delta
/// lights.
Rgb direct_light(const LightTransport& transport, const Interaction& at, VertexSampler& sampler,
                 Tracer& tracer);

}  // namespace twinray
