// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "core/bsdf.h"
#include "core/regularize.h"
#include "core/scene.h"
#include "core/surface.h"

namespace twinray {

/// The scattering functions of a scene's materials, made once: some take longer to make than to evaluate.
class BsdfTable {
 public:
  /// The scene must outlive it.
  explicit BsdfTable(const Scene& scene);
  /// That of the surface at a point, for a viewer on one side; made anew where textures have a part in it.
  Bsdf at(const SurfacePoint& point, Side side, Materials materials = Materials::exact) const;

 private:
  const Scene& scene_;
  std::vector<Bsdf> made_;  ///< Of each material: exact outside and inside, regularized outside and inside.
};

}  // namespace twinray
