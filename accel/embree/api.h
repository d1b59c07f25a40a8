// SPDX-License-Identifier: Apache-2.0
// Private: Embree's interface, and the few lines in which versions 3 and 4 differ.
#pragma once
#if TWINRAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace twinray::embree {

#if TWINRAY_EMBREE_MAJOR >= 4

using Context = RTCRayQueryContext;

inline void initialize(Context& context) { rtcInitRayQueryContext(&context); }

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}

#else

using Context = RTCIntersectContext;

inline void initialize(Context& context) { rtcInitIntersectContext(&context); }

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
  rtcIntersect1(scene, &context, &ray);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray) { rtcOccluded1(scene, &context, &ray); }

#endif

}  // namespace twinray::embree
