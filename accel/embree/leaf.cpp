// SPDX-License-Identifier: Apache-2.0
// The leaf that Embree calls, compiled once for each instruction set.
#include "accel/embree/leaf.h"

#include "core/instruction_sets.h"

#define HWY_TARGET_INCLUDE "accel/embree/leaf.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "accel/canonical/block_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {
namespace {

HWY_ATTR void intersect(const RTCIntersectFunctionNArguments* arguments) {
  auto& query = *static_cast<embree::LeafQuery*>(arguments->context);
  const PrimitiveBlock& block = query.enter(arguments->primID);
  BlockRay(query.ray).closest(query.geometry, query.ray, block, query.best);
  query.shorten(*reinterpret_cast<RTCRayHit*>(arguments->rayhit));
}

HWY_ATTR void occlude(const RTCOccludedFunctionNArguments* arguments) {
  auto& query = *static_cast<embree::LeafQuery*>(arguments->context);
  const PrimitiveBlock& block = query.enter(arguments->primID);
  query.is_hit = BlockRay(query.ray).any(query.geometry, query.ray, block);
  query.end_if_hit(*reinterpret_cast<RTCRay*>(arguments->ray));
}

[[maybe_unused]] embree::LeafFunctions functions() {
  return {simd_name(hwy::TargetName(HWY_TARGET)), intersect, occlude};
}

}  // namespace
}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray::embree {
namespace {

void intersect_scalar(const RTCIntersectFunctionNArguments* arguments) {
  auto& query = *static_cast<LeafQuery*>(arguments->context);
  const PrimitiveBlock& block = query.enter(arguments->primID);
  query.best.test(query.geometry, query.ray, block, block.triangles | block.spheres | block.others);
  query.shorten(*reinterpret_cast<RTCRayHit*>(arguments->rayhit));
}

void occlude_scalar(const RTCOccludedFunctionNArguments* arguments) {
  auto& query = *static_cast<LeafQuery*>(arguments->context);
  Hit found;
  test_block<QueryKind::any>(query.geometry, query.ray, query.enter(arguments->primID), found);
  query.is_hit = bool(found);
  query.end_if_hit(*reinterpret_cast<RTCRay*>(arguments->ray));
}

}  // namespace

std::vector<LeafFunctions> leaf_functions() {
  std::vector<LeafFunctions> all;
  TWINRAY_APPEND_SUPPORTED(all, functions());
  all.push_back({"scalar", intersect_scalar, occlude_scalar});
  return all;
}

}  // namespace twinray::embree
#endif
