// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/light_set.h"
#include "core/scene.h"
#include "integrators/integrator.h"
#include "integrators/path_options.h"

namespace twinray {

/// Unidirectional path tracing with light sampling at each vertex (Kajiya, "The Rendering Equation", 1986),
/// one path after the other: the code to read first, and what PathIntegrator's waves are held to, bit for
/// bit.
///
/// At vertex d the light scattered d + 1 times is estimated by direct_light; emission that a bounce ray hits
/// has been counted there, so it is added for the camera ray alone.
class PathReference final : public Integrator {
 public:
  /// The scene must outlive the integrator. Throws Error for options out of range.
  PathReference(const Scene& scene, const PathOptions& options);
  Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key, Tracer& tracer) const override;

 private:
  /// Chooses where the path goes on from its vertex `depth`; false where it ends.
  bool scatter(const Interaction& at, int depth, const VertexSampler& sampler, Rgb& throughput,
               Ray& ray) const;
  bool survives_roulette(int bounce, const VertexSampler& sampler, Rgb& throughput) const;

  const Scene& scene_;
  PathOptions options_;
  LightSet lights_;
};

}  // namespace twinray
