// SPDX-License-Identifier: Apache-2.0
// The queries over the compact tree, compiled once for each instruction set.
#include "accel/compact/kernel.h"

#include "accel/wide/scalar.h"
#include "core/instruction_sets.h"  // Before Highway: which sets it leaves out.

#define HWY_TARGET_INCLUDE "accel/compact/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128  // ScalarKernel serves for these.
#include "accel/compact/unpack-inl.h"
#include "accel/wide/queries-inl.h"
#endif

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray {

std::vector<CompactKernel> compact_kernels(WideTrees trees) {
  std::vector<CompactKernel> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, kernel_for<CompactBvh>(trees));
  kernels.push_back(ScalarKernel<CompactBvh>::kernel());
  return kernels;
}

std::vector<CountingCompactKernel> counting_compact_kernels(WideTrees trees) {
  std::vector<CountingCompactKernel> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, counting_kernel_for<CompactBvh>(trees));
  return kernels;
}

}  // namespace twinray
#endif
