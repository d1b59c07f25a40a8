// SPDX-License-Identifier: Apache-2.0
#include "bench/engines.h"

#include <optional>

namespace twinray::bench {
namespace {

struct Row {
  const char* name;  ///< In the table of engines.
  Wanted wanted = Wanted::always;
  Asked asked = Asked::singly;
  const char* own_name = nullptr;  ///< Where it is asked in another way.
  const char* what = nullptr;
};

constexpr Row rows[] = {
    {"embree-native-default", Wanted::always, Asked::directly, "embree-direct",
     "rtcIntersect1 and rtcOccluded1, own triangles, robust, as Embree comes: the baseline"},
    {"embree-native-default"},
    {"embree-native"},
    {"embree-native-fast"},
    {"embree-native-fast-high"},
    {"embree"},
    {"bvh"},
    {"bvh", Wanted::always, Asked::in_batches, "bvh-batch", "the same, many rays a call"},
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

}  // namespace

std::vector<Engine> engines() {
  std::vector<Engine> all;
  for (const Row& row : rows) {
    const std::optional<twinray::Engine> found = find_engine(row.name);
    if (!found) continue;
    Engine engine{*found, row.wanted, row.asked};
    if (row.own_name) engine.name = row.own_name;
    if (row.what) engine.what = row.what;
    all.push_back(std::move(engine));
  }
  return all;
}

}  // namespace twinray::bench
