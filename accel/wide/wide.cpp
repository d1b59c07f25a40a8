// SPDX-License-Identifier: Apache-2.0
// The hand-written eight-wide BVH as an accelerator.
#include "accel/backends.h"
#include "accel/wide/build.h"
#include "accel/wide/engine.h"
#include "core/instruction_sets.h"

namespace twinray {

std::unique_ptr<Accelerator> build_wide_bvh(std::shared_ptr<const Geometry> geometry,
                                            const BuildOptions& options) {
  const WideKernel kernel = chosen(wide_kernels(trees_of(*geometry)), options.simd);
  AccelStats stats;
  WideBvh bvh = make_wide_bvh(*geometry, options, stats.phases);
  return make_wide_accelerator(std::move(geometry), std::move(bvh), kernel, options, std::move(stats));
}

}  // namespace twinray
