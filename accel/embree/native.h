// SPDX-License-Identifier: Apache-2.0
// Private: the scene of an engine embree_native, for who asks it without the interface.
#pragma once
#include "accel/accelerator.h"
#include "accel/embree/api.h"

namespace twinray::embree {

struct NativeScene {
  RTCScene scene;      ///< The engine's.
  bool has_callbacks;  ///< Which want a checked ray: of spheres, and of shapes that are not opaque.
};

/// Throws Error for another engine.
NativeScene native_scene(const Accelerator& accelerator);

}  // namespace twinray::embree
