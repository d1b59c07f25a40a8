// SPDX-License-Identifier: Apache-2.0
// The rays that light paths really trace, for whoever wants to shoot them again.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/camera.h"
#include "integrators/integrator.h"
#include "integrators/path.h"

namespace twinray {

/// Appends the rays of one sample, in the order in which they are traced. `frame` is the point of the
/// camera's frame, (0, 0) to (1, 1).
void record_sample(const Integrator& integrator, const Camera& camera, const Accelerator& accelerator,
                   Vec2 frame, const SampleKey& key, std::vector<RecordedRay>& rays);

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
