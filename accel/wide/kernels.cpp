// SPDX-License-Identifier: Apache-2.0
// The queries over the ordinary eight-wide BVH, compiled once for each instruction set.
#include "accel/wide/kernel.h"

#include "accel/wide/scalar.h"
#include "core/instruction_sets.h"  // Before Highway: which sets it leaves out.

#define HWY_TARGET_INCLUDE "accel/wide/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128  // ScalarKernel serves for these.
#include "accel/wide/queries-inl.h"
#endif

#if HWY_ONCE
#include "core/supported_sets.h"

namespace twinray {

std::vector<WideKernel> wide_kernels(WideTrees trees) {
  std::vector<WideKernel> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, kernel_for<WideBvh>(trees));
  kernels.push_back(ScalarKernel<WideBvh>::kernel());
  return kernels;
}

std::vector<CountingWideKernel> counting_wide_kernels(WideTrees trees) {
  std::vector<CountingWideKernel> kernels;
  TWINRAY_APPEND_SUPPORTED(kernels, counting_kernel_for<WideBvh>(trees));
  return kernels;
}

}  // namespace twinray
#endif
