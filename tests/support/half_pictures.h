// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "integrators/denoise/denoise.h"

namespace twinray::test {

/// The picture of both halves, by the own filter.
inline Image denoised(const HalfPictures& noisy) {
  return picture_of(denoised_halves(noisy), noisy.second_weight);
}

}  // namespace twinray::test
