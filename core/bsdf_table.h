// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/bsdf.h"
#include "core/interiors.h"
#include "core/regularize.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// How a path sees the surfaces that it comes to.
struct Viewing {
  Materials materials = Materials::exact;
  Interiors interiors = {};  ///< That it is in.
};

/// The scattering functions of a scene's materials, made once: some take longer to make than to evaluate.
class BsdfTable {
 public:
  /// The scene must outlive it.
  explicit BsdfTable(const Scene& scene);

  const Scene& scene() const { return scene_; }
  /// That of a material, not a Mix, at a point, for a viewer on one side; made anew where textures have a
  /// part in it, or what is around.
  Bsdf at(std::uint32_t material, const SurfacePoint& point, Side side, const Viewing& viewing = {}) const;

 private:
  const Scene& scene_;
  std::vector<Bsdf> made_;  ///< Of each material: exact outside and inside, regularized outside and inside.
};

}  // namespace twinray
