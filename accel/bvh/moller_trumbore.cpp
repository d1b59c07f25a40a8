// SPDX-License-Identifier: Apache-2.0
// The binary BVH with Möller and Trumbore's triangle test in its leaves, one triangle after the other: an
// engine to compare with, outside of the promise of equal bits.
#include "accel/canonical/moller_trumbore.h"
#include "accel/backends.h"
#include "accel/bvh/build.h"
#include "accel/bvh/statistics.h"
#include "accel/bvh/traversal.h"

namespace twinray {
namespace {

class MollerTrumboreBvh final : public Accelerator {
 public:
  MollerTrumboreBvh(std::shared_ptr<const Geometry> geometry, Bvh bvh, AccelStats stats)
      : Accelerator(std::move(geometry), std::move(stats)), bvh_(std::move(bvh)) {}

 private:
  Hit closest(Query query) const noexcept override {
    return closest_of(query.ray, [&](const CheckedRay& ray) { return least_hit(ray, query.counts, false); });
  }
  bool any(Query query) const noexcept override {
    return any_of(query.ray, [&](const CheckedRay& ray) { return bool(least_hit(ray, query.counts, true)); });
  }

  /// Of all primitives, or of those up to the first leaf with a hit.
  Hit least_hit(const CheckedRay& ray, QueryCounts* counts, bool ends_at_first) const {
    Hit best;
    float t_max = ray.t_max;
    QueryCounts uncounted;
    traverse(bvh_, ray, t_max, Counting{counts ? *counts : uncounted}, [&](const TriangleBlock& block) {
      for (std::uint32_t lane = 0; lane < block.count; ++lane) test(ray, block.ids[lane], best);
      t_max = std::min(t_max, best.t);
      return ends_at_first && best;
    });
    return best;
  }

  /// As test_primitive() of accel/canonical/shape_test.h.
  void test(const CheckedRay& ray, PrimitiveId id, Hit& best) const {
    const Mesh* mesh = geometry().mesh(id.mesh);
    if (!mesh) return test_primitive(geometry(), ray, id, best);
    const auto [a, b, c] = mesh->triangles[id.primitive];
    const float t_max = std::min(ray.t_max, best.t);
    ShapeHit found;
    if (!intersect_moller_trumbore(ray, mesh->positions[a], mesh->positions[b], mesh->positions[c], t_max,
                                   found))
      return;
    const Hit hit{found.t, found.u, found.v, id.primitive, id.mesh, no_instance};
    if (precedes(hit, best)) best = hit;
  }

  Bvh bvh_;
};

}  // namespace

std::unique_ptr<Accelerator> build_moller_trumbore(std::shared_ptr<const Geometry> geometry,
                                                   const BuildOptions& options) {
  AccelStats stats;
  Bvh bvh = make_bvh(*geometry, options, stats.phases);
  stats.bytes = bvh.bytes();
  stats.tree = statistics_of(bvh, options);
  return std::make_unique<MollerTrumboreBvh>(std::move(geometry), std::move(bvh), std::move(stats));
}

}  // namespace twinray
