// SPDX-License-Identifier: Apache-2.0
#include "bench/engines.h"

#include <algorithm>

namespace twinray::bench {
namespace {

BuildOptions native(EmbreeMode mode, EmbreeQuality quality, const char* isa) {
  return {.embree_mode = mode, .embree_quality = quality, .embree_isa = isa};
}

std::vector<Engine> table() {
  using enum EmbreeMode;
  using enum EmbreeQuality;
  using enum Wanted;
  return {
      {"embree-direct", Backend::embree_native, native(robust, medium, "default"), always,
       "rtcIntersect1 and rtcOccluded1, own triangles, robust, as Embree comes: the baseline",
       Asked::directly},
      {"embree-native", Backend::embree_native, native(robust, medium, "default"), always,
       "the same through the interface that all engines share"},
      {"embree-native-avx2", Backend::embree_native, native(robust, medium, "avx2"), always,
       "the same, with AVX2 at most"},
      {"embree-fast", Backend::embree_native, native(fast, medium, "default"), always,
       "Embree's own triangles, fast mode: rays may slip through edges"},
      {"embree-fast-high", Backend::embree_native, native(fast, high, "default"), always,
       "fast mode over a tree with spatial splits"},
      {"embree", Backend::embree, {}, always, "Embree's traversal with our canonical leaf"},
      {"bvh", Backend::bvh, {}, always, "our BVH as it comes"},
      {"bvh-batch", Backend::bvh, {}, always, "the same, many rays a call", Asked::in_batches},
      {"bvh-fast", Backend::bvh, {.bvh_quality = BvhQuality::fast}, always, "our BVH, built in less time"},
      {"bvh-high", Backend::bvh, {.bvh_quality = BvhQuality::high}, always, "our BVH, built with more care"},
      {"bvh-binary", Backend::bvh, {.bvh_width = 2}, always, "our readable BVH of two children a node"},
      {"bvh-binary-median",
       Backend::bvh,
       {.bvh_width = 2, .bvh_split = BvhSplit::median},
       full,
       "split into halves by count"},
      {"bvh-binary-midpoint",
       Backend::bvh,
       {.bvh_width = 2, .bvh_split = BvhSplit::midpoint},
       full,
       "split in the middle"},
      {"bvh-binary-mean",
       Backend::bvh,
       {.bvh_width = 2, .bvh_split = BvhSplit::mean},
       full,
       "split at the mean centroid"},
      {"bvh-embree-low",
       Backend::bvh,
       {.bvh_builder = BvhBuilder::embree_low},
       full,
       "our BVH over Embree's Morton builder"},
      {"bvh-embree-medium",
       Backend::bvh,
       {.bvh_builder = BvhBuilder::embree_medium},
       full,
       "our BVH over Embree's binned builder"},
      {"bvh-embree-high",
       Backend::bvh,
       {.bvh_builder = BvhBuilder::embree_high},
       full,
       "our BVH over Embree's builder with spatial splits"},
      {"brute-force", Backend::brute_force, {}, small, "every ray against every primitive"},
  };
}

bool is_available(const Engine& engine) {
  const std::vector<Backend> backends = available_backends();
  const std::vector<BvhBuilder> builders = available_builders();
  return std::find(backends.begin(), backends.end(), engine.backend) != backends.end() &&
         std::find(builders.begin(), builders.end(), engine.options.bvh_builder) != builders.end();
}

}  // namespace

std::vector<Engine> engines() {
  std::vector<Engine> all;
  for (Engine& engine : table())
    if (is_available(engine)) all.push_back(std::move(engine));
  return all;
}

}  // namespace twinray::bench
