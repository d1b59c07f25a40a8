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

/// A hit that has Embree's numbers of shape and instance, with ours. To Embree the shapes that stand in the
/// scene directly come first, and the instances behind them; a prototype's shapes are counted from its first.
inline Hit named(Hit hit, const Geometry& geometry) {
  static_assert(RTC_INVALID_GEOMETRY_ID == no_instance);
  if (hit.instance == no_instance) return hit;
  hit.instance -= geometry.direct_shapes().count;
  hit.mesh += geometry.prototypes()[geometry.instances()[hit.instance].prototype].first;
  return hit;
}

/// Throws Error for another engine.
NativeScene native_scene(const Accelerator& accelerator);

}  // namespace twinray::embree
