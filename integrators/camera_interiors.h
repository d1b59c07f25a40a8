// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "accel/accelerator.h"
#include "core/camera.h"
#include "core/scene.h"
#include "integrators/integrator.h"

namespace twinray {

/// Where camera rays start: in which interiors of a scene.
///
/// A point is in what a straight way to it from outside of the scene has entered and not left. Two opposite
/// ways must agree, so that nothing is in a body that is not closed. Around all bodies is the scene's
/// atmosphere.
class CameraInteriors {
 public:
  /// The scene and the accelerator, which is one of its geometry, must outlive it.
  CameraInteriors(const Scene& scene, const Accelerator& accelerator, const Camera& camera);
  /// Sets those of each sample.
  void find(std::span<CameraSample> samples) const;

 private:
  Interiors at(const Vec3& point) const;
  /// What there is outside of all bodies.
  Interiors around_all() const;
  /// What a way along `direction` is in where it ends.
  Interiors along(const Vec3& direction, const Vec3& point) const;

  const Scene& scene_;
  const Accelerator& accelerator_;
  Aabb bodies_;                      ///< All that has an interior lies within it.
  std::optional<Interiors> of_all_;  ///< Where all rays start at one point.
};

}  // namespace twinray
