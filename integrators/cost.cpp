// SPDX-License-Identifier: Apache-2.0
#include "integrators/cost.h"

namespace twinray {

Rgb CostIntegrator::radiance_of(const CameraSample& sample, SamplerKind, Tracer& tracer) const {
  const QueryCounts before = tracer.counts().queries;
  tracer.camera_hit(sample.ray);
  const QueryCounts& after = tracer.counts().queries;
  const std::uint64_t count =
      kind_ == CostKind::nodes ? after.nodes - before.nodes : after.primitives - before.primitives;
  return {float(count), float(count), float(count)};
}

}  // namespace twinray
