// SPDX-License-Identifier: Apache-2.0
// The hand-written BVH as an accelerator.
#include "accel/backends.h"
#include "accel/build/binary_tree.h"
#include "accel/bvh/statistics.h"
#include "accel/bvh/traversal.h"
#include "accel/checked_accelerator.h"

namespace twinray {
namespace {

/// `test`: which triangle test the leaves run.
template <TriangleTest test>
class BvhAccelerator final : public CheckedAccelerator {
 public:
  BvhAccelerator(std::shared_ptr<const Geometry> geometry, const BuildOptions& options)
      : geometry_(std::move(geometry)) {
    bvh_ = make_bvh(*geometry_, options, stats_.phases);
    add_statistics(bvh_, options, stats_);
    stats_.primitives = geometry_->primitive_count();
  }

  Aabb bounds() const noexcept override { return geometry_->bounds(); }
  AccelStats stats() const override { return stats_; }

 private:
  Hit trace_closest(const CheckedRay& ray) const noexcept override { return closest(ray, NoCounts{}); }
  bool trace_any(const CheckedRay& ray) const noexcept override { return any(ray, NoCounts{}); }
  Hit count_closest(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    return closest(ray, Counting{counts});
  }
  bool count_any(const CheckedRay& ray, QueryCounts& counts) const noexcept override {
    return any(ray, Counting{counts});
  }

  template <typename Counts>
  Hit closest(const CheckedRay& ray, Counts counts) const {
    Hit best;
    float t_max = ray.t_max;
    traverse(bvh_, ray, t_max, counts, [&](const TriangleBlock& block) {
      test_block<QueryKind::closest, test>(*geometry_, ray, block, best);
      t_max = std::min(t_max, best.t);
      return false;
    });
    return best;
  }

  template <typename Counts>
  bool any(const CheckedRay& ray, Counts counts) const {
    Hit found;
    traverse(bvh_, ray, ray.t_max, counts, [&](const TriangleBlock& block) {
      test_block<QueryKind::any, test>(*geometry_, ray, block, found);
      return !found.is_miss();
    });
    return !found.is_miss();
  }

  std::shared_ptr<const Geometry> geometry_;
  Bvh bvh_;
  AccelStats stats_;
};

}  // namespace

std::unique_ptr<Accelerator> build_bvh(std::shared_ptr<const Geometry> geometry,
                                       const BuildOptions& options) {
  if (options.triangle_test == TriangleTest::moller_trumbore)
    return std::make_unique<BvhAccelerator<TriangleTest::moller_trumbore>>(std::move(geometry), options);
  return std::make_unique<BvhAccelerator<TriangleTest::woop>>(std::move(geometry), options);
}

}  // namespace twinray
