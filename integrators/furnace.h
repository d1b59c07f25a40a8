// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/bsdf_table.h"
#include "core/scene.h"
#include "integrators/integrator.h"
#include "integrators/interaction.h"
#include "integrators/way.h"

namespace twinray {

/// The white furnace: the scene's surfaces under a sky of radiance 1 all around, all its own lights out. A
/// material that loses no energy cannot be told from the sky; what is darker has absorbed light, what is
/// brighter has made some.
///
/// Directions are sampled by the scattering functions alone, and no path is given up at random: of a surface
/// that loses nothing each sample is 1, without noise, where its sampling is perfect. Light of paths that are
/// scattered more than `max_depth` times is lost.
class FurnaceIntegrator final : public PlainIntegrator {
 public:
  /// The scene must outlive the integrator.
  FurnaceIntegrator(const Scene& scene, int max_depth)
      : bsdfs_(scene, Materials::exact), max_depth_(max_depth), has_flights_(has_flights(scene.materials)) {}

 private:
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer) const override;
  /// Where a path has come to.
  Interaction arrive(const Way& way, const VertexSampler& sampler, const Viewing& viewing) const;

  BsdfTable bsdfs_;
  int max_depth_;
  bool has_flights_;
};

}  // namespace twinray
