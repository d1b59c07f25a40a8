// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>
#include <string>

#include "core/scene.h"
#include "integrators/integrator.h"
#include "integrators/path_options.h"

namespace twinray {

/// The path tracer of PathReference, with the same bits, many paths at a time: what they do at their vertices
/// is done in lanes, stage by stage (integrators/wave). Where a medium scatters light, path after path.
class PathIntegrator final : public Integrator {
 public:
  /// The scene must outlive the integrator. `simd` is one of available_instruction_sets(); "scalar" traces
  /// path after path. Throws Error for options out of range.
  PathIntegrator(const Scene& scene, const PathOptions& options, const std::string& simd = "best");
  ~PathIntegrator() override;
  void sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
              const RecordSpans& records) const override;

 private:
  class Waves;
  std::unique_ptr<const Waves> waves_;
};

}  // namespace twinray
