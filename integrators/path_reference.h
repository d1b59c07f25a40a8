// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "core/light_set.h"
#include "core/scene.h"
#include "integrators/direct_light.h"
#include "integrators/integrator.h"
#include "integrators/light_division.h"
#include "integrators/light_paths.h"
#include "integrators/path_options.h"

namespace twinray {

class WalkDraws;

/// Unidirectional path tracing with light sampling at each vertex (Kajiya, "The Rendering Equation", 1986),
/// one path after the other: the code to read first, and what PathIntegrator's waves are held to, bit for
/// bit.
///
/// At vertex d the light scattered d + 1 times is estimated by direct_light; of the emission that a bounce
/// ray hits, found_light adds what has not been counted there. The tracer's observer is told every step.
class PathReference final : public Integrator {
 public:
  /// The scene must outlive the integrator. Throws Error for options out of range.
  PathReference(const Scene& scene, const PathOptions& options);
  void sample(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
              const RecordSpans& records) const override;

  // What waves of the same scene and options share with it.
  LightTransport transport() const {
    return {scene_,
            lights_,
            options_.direct,
            options_.samples_per_light,
            passages_.empty() ? nullptr : &passages_,
            has_glow_};
  }
  const BsdfTable& bsdfs() const { return bsdfs_; }
  const Passages& passages() const { return passages_; }

 private:
  /// A path on its way.
  struct State {
    Ray ray;
    Departure departure;  ///< Of the ray, behind the first surface.
    Rgb throughput{1, 1,
                   1};  ///< Product of f |cos| / p of all vertices so far (solid angle), and of roulette.
    Viewing viewing;    ///< Regularized after a wide lobe, where that is asked for.
    RayCone cone;       ///< Around the ray; followed where there are textures.
    BounceCounts bounces = 0;
    float eta_squared = 1;    ///< Product of eta^2: where the camera is, radiance is that much smaller.
    bool is_followed = true;  ///< It was scattered by mirrors and the like alone.
    bool is_below = false;    ///< Its ray goes below a surface.
    FirstScattering first;    ///< Where the light's parts are asked for.
  };
  /// One path; `record` has room for one sample.
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer& tracer,
                  const RecordSpans& record) const;
  /// What a camera ray brings from an emitter that it hits, or from beyond the scene.
  Rgb seen_light(const LightTransport& transport, const Arrival& arrival, PathObserver& observer,
                 const LightGroups& groups) const;
  /// The term of the radiance that light is which was scattered `depth` times.
  LightTerm term(const Rgb& throughput, const Rgb& light, int depth) const;
  /// Where a ray of the path ends: at its hit, or at a point in a medium before that.
  struct End {
    Hit hit;
    std::optional<Vec3> in_medium;  ///< Then the hit is a miss.
    Rgb glow;                       ///< What media on the way add to the sample's radiance.

    bool is_beyond_scene() const { return hit.is_miss() && !in_medium; }
  };
  /// Follows the path's ray from the vertex of the sampler to its end, through what is not there, and takes
  /// from the throughput what media keep on the way.
  End fly(Tracer& tracer, const VertexSampler& sampler, State& path, RayKind kind) const;
  /// Writes what is asked for of where a path has come to after `depth` scattering events.
  void record_vertex(const Interaction& at, const Hit& hit, int depth, const State& path,
                     const RecordSpans& record) const;
  /// Where a path has come to.
  Interaction arrive(const End& end, const VertexSampler& sampler, State& path) const;
  /// Where a path comes out that goes below the surface there; none where it is absorbed.
  std::optional<Interaction> emerge(const Interaction& from, const WalkDraws& draws, Tracer& tracer,
                                    State& path) const;
  /// Chooses where the path goes on from its vertex `depth`; false where it ends.
  bool scatter(const Interaction& at, int depth, const VertexSampler& sampler, State& path,
               PathObserver& observer) const;
  bool survives_roulette(int bounce, const VertexSampler& sampler, State& path, PathObserver& observer) const;

  const Scene& scene_;
  PathOptions options_;
  LightSet lights_;
  BsdfTable bsdfs_;
  Passages passages_;
  bool has_environment_;
  bool has_flights_, has_glow_;
};

}  // namespace twinray
