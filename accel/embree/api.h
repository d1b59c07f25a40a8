// SPDX-License-Identifier: Apache-2.0
// Private: Embree's interface, and the few lines in which versions 3 and 4 differ.
#pragma once
#include <span>

#if TWINRAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace twinray::embree {

// trace() finds the closest hit of what has room for it (RTCRayHit, RTCRayHit16), and whether there is any of
// what has none (RTCRay, RTCRay16).

#if TWINRAY_EMBREE_MAJOR >= 4

using Context = RTCRayQueryContext;

inline void initialize(Context& context) { rtcInitRayQueryContext(&context); }

/// What Embree is told of the rays of a packet or stream.
struct Coherence {
  RTCRayQueryFlags flags;
};
inline constexpr Coherence coherent{RTC_RAY_QUERY_FLAG_COHERENT}, incoherent{RTC_RAY_QUERY_FLAG_INCOHERENT};
inline constexpr bool has_streams = false;

inline void trace(RTCScene scene, Context& context, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void trace(RTCScene scene, Context& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}

/// Of 16 rays those whose `active` is -1.
inline void trace(RTCScene scene, Coherence coherence, const int* active, RTCRayHit16& rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = coherence.flags;
  rtcIntersect16(active, scene, &rays, &arguments);
}

inline void trace(RTCScene scene, Coherence coherence, const int* active, RTCRay16& rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = coherence.flags;
  rtcOccluded16(active, scene, &rays, &arguments);
}

#else

using Context = RTCIntersectContext;

inline void initialize(Context& context) { rtcInitIntersectContext(&context); }

/// What Embree is told of the rays of a packet or stream.
struct Coherence {
  RTCIntersectContextFlags flags;
};
inline constexpr Coherence coherent{RTC_INTERSECT_CONTEXT_FLAG_COHERENT},
    incoherent{RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT};
inline constexpr bool has_streams = true;

inline Context context_of(Coherence coherence) {
  Context context;
  initialize(context);
  context.flags = coherence.flags;
  return context;
}

inline void trace(RTCScene scene, Context& context, RTCRayHit& ray) { rtcIntersect1(scene, &context, &ray); }

inline void trace(RTCScene scene, Context& context, RTCRay& ray) { rtcOccluded1(scene, &context, &ray); }

/// Of 16 rays those whose `active` is -1.
inline void trace(RTCScene scene, Coherence coherence, const int* active, RTCRayHit16& rays) {
  Context context = context_of(coherence);
  rtcIntersect16(active, scene, &context, &rays);
}

inline void trace(RTCScene scene, Coherence coherence, const int* active, RTCRay16& rays) {
  Context context = context_of(coherence);
  rtcOccluded16(active, scene, &context, &rays);
}

/// Streams: of rays, or of packets of 16. Of those that are not to be traced t_min lies behind t_max.
inline void trace(RTCScene scene, Coherence coherence, std::span<RTCRayHit> rays) {
  Context context = context_of(coherence);
  rtcIntersect1M(scene, &context, rays.data(), unsigned(rays.size()), sizeof(RTCRayHit));
}

inline void trace(RTCScene scene, Coherence coherence, std::span<RTCRay> rays) {
  Context context = context_of(coherence);
  rtcOccluded1M(scene, &context, rays.data(), unsigned(rays.size()), sizeof(RTCRay));
}

inline void trace(RTCScene scene, Coherence coherence, std::span<RTCRayHit16> packets) {
  Context context = context_of(coherence);
  rtcIntersectNM(scene, &context, reinterpret_cast<RTCRayHitN*>(packets.data()), 16, unsigned(packets.size()),
                 sizeof(RTCRayHit16));
}

inline void trace(RTCScene scene, Coherence coherence, std::span<RTCRay16> packets) {
  Context context = context_of(coherence);
  rtcOccludedNM(scene, &context, reinterpret_cast<RTCRayN*>(packets.data()), 16, unsigned(packets.size()),
                sizeof(RTCRay16));
}

#endif

}  // namespace twinray::embree
