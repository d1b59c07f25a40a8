// SPDX-License-Identifier: Apache-2.0
// Direct light: estimators of the light that emitters send to a surface and that it scatters to the
// viewer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/light_set.h"
#include "core/sampler.h"
#include "integrators/interaction.h"
#include "integrators/tracer.h"

namespace twinray {

enum class DirectMethod {
  lights,      ///< Points of the lights are sampled.
  hemisphere,  ///< Directions are sampled, uniformly; the emitters that they hit count. Never hits a delta
               ///< light.
};

/// Everything a light estimate needs besides the point: constant while a scene is rendered.
struct LightTransport {
  const Scene& scene;
  const LightSet& lights;
  DirectMethod method = DirectMethod::lights;
  std::uint32_t samples_per_light = 1;  ///< For each light that is not a delta light; >= 1.
};

/// Estimates of the light of all emitters, scattered once at a surface; by `hemisphere`, of all but delta
/// lights. Unbiased. Those of many surfaces are made together: first their samples are drawn, then all
/// shadow rays are traced at once.
class DirectLight {
 public:
  explicit DirectLight(const LightTransport& transport);

  /// Draws the samples of one estimate. Then, or in finish(), throughput times the estimate is added to
  /// `radiance`, which must live until finish() has returned.
  void draw(const Interaction& at, const Rgb& throughput, VertexSampler& sampler, Tracer& tracer,
            Rgb& radiance);
  /// Traces what has been drawn and not yet added, and adds it.
  void finish(Tracer& tracer);

 private:
  /// f L |cos| of one sample of one light, if nothing is in the way.
  struct Term {
    Rgb scattered;
    float pdf;  ///< Per solid angle.
    std::uint32_t light;
  };
  struct Estimate {
    Rgb* radiance;
    Rgb throughput;
    Rgb known;          ///< What needs no shadow ray.
    std::size_t terms;  ///< How many there are up to the last one of this estimate.
  };

  void draw_lights(const Interaction& at, VertexSampler& sampler);
  Rgb sum(std::size_t begin, std::size_t end, std::span<const Rgb> visible) const;

  LightTransport transport_;
  std::vector<std::uint32_t> parts_;  ///< How many samples each light gets.
  std::vector<Estimate> estimates_;
  std::vector<Term> terms_;
  std::vector<Ray> shadow_rays_;  ///< Of each term.
};

}  // namespace twinray
