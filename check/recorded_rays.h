// SPDX-License-Identifier: Apache-2.0
// The rays that light paths trace, recorded so that others can trace them again.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/ray_class.h"
#include "core/camera.h"
#include "integrators/integrator.h"
#include "integrators/path.h"

namespace twinray {

/// Appends the rays of one sample, in the order in which they are traced. `frame` is the point of the
/// camera's frame, (0, 0) to (1, 1).
void record_sample(const Integrator& integrator, const Camera& camera, const Accelerator& accelerator,
                   Vec2 frame, const SampleKey& key, std::vector<RecordedRay>& rays);

/// How much of a picture is recorded: by default CS184's usual one, thinned out.
struct Recording {
  int width = 160, height = 120;  ///< Pixels, >= 1.
  std::uint32_t samples = 1;      ///< Per pixel, >= 1; a single one goes through the pixel's centre.
  int max_depth = 5;
};

/// All rays of a path-traced picture of the scene (one light sample a hit), row by row. The same on every
/// machine. Throws Error for a depth out of range.
std::vector<RecordedRay> record_rays(const Scene& scene, const Recording& recording = {});

/// The class in which a crosscheck counts rays of a kind.
RayClass class_of(RayKind kind);

/// The rays of one kind, in their order.
std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind);
/// Those of them that start at one vertex of their paths.
std::vector<Ray> rays_of_kind(const std::vector<RecordedRay>& recorded, RayKind kind, int vertex);

/// Rays of light paths without end, in batches that any thread may make. Half of the paths start at the
/// scene's camera, half where its view shows the whole scene.
class PathRays {
 public:
  /// Scene and accelerator must outlive this.
  PathRays(const Scene& scene, const Accelerator& accelerator, std::uint64_t seed);
  /// `count` rays of paths of up to five bounces; a function of scene, seed, batch and count.
  std::vector<RecordedRay> batch(std::uint64_t batch, std::size_t count) const;

 private:
  const Accelerator& accelerator_;
  std::uint64_t seed_;
  PathIntegrator path_;
  Camera cameras_[2];
};

}  // namespace twinray
