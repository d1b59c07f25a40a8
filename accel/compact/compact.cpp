// SPDX-License-Identifier: Apache-2.0
// The compact tree as an accelerator.
#include "accel/backends.h"
#include "accel/compact/build.h"
#include "accel/compact/kernel.h"
#include "accel/wide/engine.h"
#include "core/instruction_sets.h"

namespace twinray {

std::unique_ptr<Accelerator> build_compact_bvh(std::shared_ptr<const Geometry> geometry,
                                               const BuildOptions& options) {
  const CompactKernel kernel = chosen(compact_kernels(trees_of(*geometry)), options.simd);
  AccelStats stats;
  CompactBvh bvh = make_compact_bvh(*geometry, options, stats.phases);
  release_freed_memory();  // Else the process would keep much of what building took.
  return make_wide_accelerator(std::move(geometry), std::move(bvh), kernel, options, std::move(stats));
}

}  // namespace twinray
