// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "core/light_set.h"
#include "core/scene.h"
#include "integrators/direct_light.h"
#include "integrators/integrator.h"

namespace twinray {

/// When a path is given up at random (and its weight raised, so that the mean stays).
struct Roulette {
  /// A fixed probability of going on, in (0, 1], from the second bounce on. 0: the path's largest throughput
  /// component, up to 1, from the fourth bounce on.
  float continuation = 0;
};

struct PathOptions {
  int max_depth = 5;  ///< Scattering events: 0 emission only, 1 direct light, ...; 0 to 100.
  /// Only light that was scattered first_depth to last_depth times is added up (within max_depth).
  int first_depth = 0, last_depth = std::numeric_limits<int>::max();
  DirectMethod direct = DirectMethod::lights;
  std::uint32_t samples_per_light = 1;  ///< 1 to 65536.
  Roulette roulette;
};

/// Unidirectional path tracing with light sampling at each vertex (Kajiya, "The Rendering Equation", 1986).
///
/// At vertex d the light scattered d + 1 times is estimated by DirectLight; emission that a bounce ray
/// hits has been counted there, so it is added for the camera ray and behind delta surfaces only. Roulette
/// decides about late bounces (struct Roulette).
///
/// Paths grow in waves: all of them advance to their next vertex, then their shadow rays are traced, then
/// their bounce rays. The terms of each path are added in the order they would have if it were traced alone.
class PathIntegrator final : public Integrator {
 public:
  /// The scene must outlive the integrator. Throws Error for options out of range.
  PathIntegrator(const Scene& scene, const PathOptions& options);
  Rgb radiance(const Ray& camera_ray, SamplerKind kind, const SampleKey& key, Tracer& tracer) const override;
  void radiances(std::span<const CameraSample> samples, SamplerKind kind, Tracer& tracer,
                 std::span<Rgb> estimates) const override;

 private:
  struct Path;
  struct Wave;
  bool counts(int depth) const { return depth >= options_.first_depth && depth <= options_.last_depth; }
  int depth_limit() const { return std::min(options_.max_depth, options_.last_depth); }
  /// All paths of a wave to their next vertices.
  void advance(Wave& wave, Tracer& tracer) const;
  /// One path to where its ray met something, and on; false where it ends.
  bool visit(Wave& wave, Path& path, Ray& ray, const Hit& hit, Tracer& tracer) const;
  void add_escaped(const Wave& wave, const Path& path, const Vec3& direction) const;
  /// Chooses where the path goes on; false where it ends.
  bool scatter(const Wave& wave, Path& path, Ray& ray, const Interaction& at, VertexSampler& sampler) const;
  /// Bounces count from 1.
  bool survives_roulette(Path& path, int bounce, VertexSampler& sampler) const;

  const Scene& scene_;
  PathOptions options_;
  LightSet lights_;
};

}  // namespace twinray
