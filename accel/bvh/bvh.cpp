// SPDX-License-Identifier: Apache-2.0
// The hand-written BVH as an accelerator.
#include "accel/backends.h"
#include "accel/bvh/build.h"
#include "accel/bvh/statistics.h"
#include "accel/bvh/traversal.h"

namespace twinray {
namespace {

class BvhAccelerator final : public Accelerator {
 public:
  BvhAccelerator(std::shared_ptr<const Geometry> geometry, Bvh bvh, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), bvh_(std::move(bvh)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(query.ray, [&](const CheckedRay& ray) {
      return query.counts ? trace_closest(ray, Counting{*query.counts}) : trace_closest(ray, NoCounts{});
    });
  }
  bool any(Query query) const noexcept override {
    return any_of(query.ray, [&](const CheckedRay& ray) {
      return query.counts ? trace_any(ray, Counting{*query.counts}) : trace_any(ray, NoCounts{});
    });
  }

  template <typename Counts>
  Hit trace_closest(const CheckedRay& ray, Counts counts) const {
    Hit best;
    float t_max = ray.t_max;
    traverse(bvh_, ray, t_max, counts, [&](const TriangleBlock& block) {
      test_block<QueryKind::closest>(geometry(), ray, block, best);
      t_max = std::min(t_max, best.t);
      return false;
    });
    return best;
  }

  template <typename Counts>
  bool trace_any(const CheckedRay& ray, Counts counts) const {
    Hit found;
    traverse(bvh_, ray, ray.t_max, counts, [&](const TriangleBlock& block) {
      test_block<QueryKind::any>(geometry(), ray, block, found);
      return !found.is_miss();
    });
    return !found.is_miss();
  }

  Bvh bvh_;
};

}  // namespace

std::unique_ptr<Accelerator> build_bvh(std::shared_ptr<const Geometry> geometry,
                                       const BuildOptions& options) {
  AccelStats stats;
  Bvh bvh = make_bvh(*geometry, options, stats.phases);
  stats.bytes = bvh.bytes();
  stats.tree = statistics_of(bvh, options);
  return std::make_unique<BvhAccelerator>(std::move(geometry), std::move(bvh), std::move(stats));
}

}  // namespace twinray
