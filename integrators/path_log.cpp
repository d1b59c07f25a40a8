// SPDX-License-Identifier: Apache-2.0
#include "integrators/path_log.h"

namespace twinray {

void PathLog::stands_at(const Interaction& at, Materials materials) {
  last().surface = at;
  last().surface->keep_bsdf();  // A log is read when its integrator is gone.
  last().materials = materials;
}

void PathLog::found_light(const FoundLight& found) {
  if (!is_black(found.radiance)) last().found.push_back(found);
}

void PathLog::sampled_light(const LightTransport& transport, const Interaction& at,
                            const TakenLightSample& taken) {
  const float pdf = at.scattered(taken.sample.direction).pdf;
  const float weight = light_sample_weight(transport, taken.source, at, taken.sample, pdf);
  last().light_samples.push_back({taken, weight, pdf});
}

void PathLog::added(const PathTerm& term) {
  // What a ray finds by itself is added before the path stands at a surface.
  (last().surface ? last().direct_light : last().emission) = term;
}

void PathLog::scattered(float lobe, Vec2 u, const Scattering* next) {
  const Interaction& at = *last().surface;
  last().scattering = {at.sample(lobe, u), next ? std::optional(*next) : std::nullopt};
}

PathEnd PathLog::end() const {
  const PathVertex& vertex = vertices_.back();
  if (!vertex.surface) return PathEnd::left;
  if (!vertex.scattering) return PathEnd::depth;
  if (!vertex.scattering->next) return PathEnd::absorbed;
  if (vertex.scattering->next->is_below) return PathEnd::below;
  return vertex.roulette && !vertex.roulette->is_survived() ? PathEnd::roulette : PathEnd::unlit;
}

Rgb PathLog::sum() const {
  Rgb sum;
  for (const PathVertex& vertex : vertices_) {
    if (vertex.glow) sum += vertex.glow->term;
    if (vertex.emission) sum += vertex.emission->term;
    if (vertex.direct_light) sum += vertex.direct_light->term;
  }
  return sum;
}

}  // namespace twinray
