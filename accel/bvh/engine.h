// SPDX-License-Identifier: Apache-2.0
// Private: the hand-written BVH as an accelerator, over any test of the primitives in its leaves.
#pragma once
#include <algorithm>
#include <memory>
#include <utility>

#include "accel/accelerator.h"
#include "accel/bvh/build.h"
#include "accel/bvh/statistics.h"
#include "accel/bvh/traversal.h"

namespace twinray {

/// Leaf has one static function template, test<kind>(geometry, ray, block, best): it tests the primitives of
/// a block against [ray.t_min, best.t] and keeps the least hit; QueryKind::any may end with the first.
template <typename Leaf>
class BvhEngine final : public Accelerator {
 public:
  BvhEngine(std::shared_ptr<const Geometry> geometry, SceneBvh bvh, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), bvh_(std::move(bvh)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      return query.counts ? trace_closest(ray, Counting{*query.counts}) : trace_closest(ray, NoCounts{});
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(geometry(), query.ray, [&](const CheckedRay& ray) {
      return query.counts ? trace_any(ray, Counting{*query.counts}) : trace_any(ray, NoCounts{});
    });
  }

  template <typename Counts>
  Hit trace_closest(const CheckedRay& ray, Counts counts) const {
    Hit best;
    float t_max = ray.t_max;
    const auto test = [&](const CheckedRay& own, const PrimitiveBlock& block) {
      Leaf::template test<QueryKind::closest>(geometry(), own, block, best);
      t_max = std::min(t_max, best.t);
      return false;
    };
    traverse_scene(bvh_, geometry(), ray, t_max, counts, test);
    return best;
  }

  template <typename Counts>
  bool trace_any(const CheckedRay& ray, Counts counts) const {
    Hit found;
    return traverse_scene(bvh_, geometry(), ray, ray.t_max, counts,
                          [&](const CheckedRay& own, const PrimitiveBlock& block) {
                            Leaf::template test<QueryKind::any>(geometry(), own, block, found);
                            return !found.is_miss();
                          });
  }

  SceneBvh bvh_;
};

/// Builds the tree and the engine over it.
template <typename Leaf>
std::unique_ptr<Accelerator> build_bvh_engine(std::shared_ptr<const Geometry> geometry,
                                              const BuildOptions& options) {
  AccelStats stats;
  SceneBvh bvh = make_scene_bvh(*geometry, options, stats.phases);
  stats.bytes = bvh.bytes();
  stats.tree = statistics_of(bvh, *geometry, options);
  return std::make_unique<BvhEngine<Leaf>>(std::move(geometry), std::move(bvh), std::move(stats));
}

}  // namespace twinray
