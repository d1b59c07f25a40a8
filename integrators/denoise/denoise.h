// SPDX-License-Identifier: Apache-2.0
// Our own denoiser: regressions over features, two bandwidths, and their best mixture. docs/denoising.md has
// what it takes away, and what it leaves.
#pragma once
#include "integrators/denoise/half_pictures.h"

namespace twinray {

/// The picture without most of its noise, of halves with the features albedo and normal, three planes each.
/// The same bits on every machine and with any number of threads. Never negative. Throws Error for other
/// features.
Image denoised(const HalfPictures& noisy);

}  // namespace twinray
