// SPDX-License-Identifier: Apache-2.0
#include "integrators/integrator.h"

namespace twinray {

void PlainIntegrator::sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                             const RecordSpans& records) const {
  records.clear();
  for (std::size_t i = 0; i < samples.size(); ++i) records.color()[i] = radiance_of(samples[i], kind, tracer);
}

}  // namespace twinray
