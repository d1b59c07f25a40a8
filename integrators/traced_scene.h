// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "accel/accelerator.h"
#include "core/scene.h"
#include "integrators/integrator.h"

namespace twinray {

/// A scene that stands still, and what renders it.
struct TracedScene {
  const Scene& scene;
  const Accelerator& accelerator;  ///< Of its geometry.
  const Integrator& integrator;    ///< Of the scene.
};

}  // namespace twinray
