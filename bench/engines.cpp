// SPDX-License-Identifier: Apache-2.0
#include "bench/engines.h"

#include <optional>

#ifdef TWINRAY_WITH_EMBREE
#include "accel/embree/direct.h"
#endif

namespace twinray::bench {
namespace {

struct Row {
  const char* name;  ///< In the table of engines.
  Wanted wanted = Wanted::always;
  Asked asked = Asked::singly;
  const char* own_name = nullptr;  ///< Where it is asked in another way.
  const char* what = nullptr;
  bool is_coherent = false;
};

constexpr Row engine_rows[] = {
    {"embree-native-default", Wanted::always, Asked::directly, "embree-direct",
     "rtcIntersect1 and rtcOccluded1, own triangles, robust, as Embree comes: the baseline"},
    {"embree-native-default", Wanted::full, Asked::in_packets, "embree-packets",
     "the same by rtcIntersect16 and rtcOccluded16: packets of 16 rays"},
    {"embree-native-default", Wanted::full, Asked::in_packets, "embree-packets-coherent",
     "the same, told that the rays are coherent", true},
    {"embree-native-default", Wanted::full, Asked::in_streams, "embree-stream",
     "by rtcIntersect1M and rtcOccluded1M: 1024 rays a call"},
    {"embree-native-default", Wanted::full, Asked::in_streams, "embree-stream-coherent",
     "the same, told that the rays are coherent", true},
    {"embree-native-default", Wanted::full, Asked::in_packet_streams, "embree-packet-stream",
     "by rtcIntersectNM and rtcOccludedNM: 64 packets of 16 rays a call"},
    {"embree-native-default", Wanted::full, Asked::in_packet_streams, "embree-packet-stream-coherent",
     "the same, told that the rays are coherent", true},
    {"embree-native-default"},
    {"embree-native"},
    {"embree-native-fast"},
    {"embree-native-fast-high"},
    {"embree"},
    {"bvh"},
    {"bvh", Wanted::always, Asked::in_batches, "bvh-batch", "the same, many rays a call"},
    {"bvh-compact"},
    {"bvh-compact", Wanted::always, Asked::in_batches, "bvh-compact-batch", "the same, many rays a call"},
    {"bvh-fast"},
    {"bvh-high"},
    {"bvh-2"},
    {"bvh-2-median", Wanted::full},
    {"bvh-2-midpoint", Wanted::full},
    {"bvh-2-mean", Wanted::full},
    {"bvh-embree-low", Wanted::full},
    {"bvh-embree-medium", Wanted::full},
    {"bvh-embree-high", Wanted::full},
    {"bvh-scalar", Wanted::full},
    {"brute-force", Wanted::small},
};

/// Embree 4 has no streams.
bool has_streams() {
#ifdef TWINRAY_WITH_EMBREE
  return embree::has(embree::Call::stream);
#else
  return false;
#endif
}

}  // namespace

std::vector<Engine> engines() {
  std::vector<Engine> all;
  for (const Row& row : engine_rows) {
    const std::optional<twinray::Engine> found = find_engine(row.name);
    if (!found || (row.asked >= Asked::in_streams && !has_streams())) continue;
    Engine engine{*found, row.wanted, row.asked, row.is_coherent};
    if (row.own_name) engine.name = row.own_name;
    if (row.what) engine.what = row.what;
    all.push_back(std::move(engine));
  }
  return all;
}

}  // namespace twinray::bench
