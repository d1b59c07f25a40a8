// SPDX-License-Identifier: Apache-2.0
// The hand-written BVH with the canonical test in its leaves.
#include "accel/backends.h"
#include "accel/bvh/engine.h"

namespace twinray {
namespace {

struct CanonicalLeaf {
  template <QueryKind kind>
  static void test(const Geometry& geometry, const CheckedRay& ray, const PrimitiveBlock& block, Hit& best) {
    test_block<kind>(geometry, ray, block, best);
  }
};

}  // namespace

std::unique_ptr<Accelerator> build_bvh(std::shared_ptr<const Geometry> geometry,
                                       const BuildOptions& options) {
  return build_bvh_engine<CanonicalLeaf>(std::move(geometry), options);
}

}  // namespace twinray
