// SPDX-License-Identifier: Apache-2.0
// Our own denoiser: regressions over features, two bandwidths, and their best mixture. docs/denoising.md has
// what it takes away, and what it leaves.
#pragma once
#include <functional>

#include "integrators/denoise/half_pictures.h"

namespace twinray {

/// Halves without most of their noise, each by the other's help, of halves with the features albedo and
/// normal, three planes each. The same bits on every machine and with any number of threads. `is_stopped`, if
/// set, is asked many times a second, from any thread: once it says true, what is returned is of no use.
/// Throws Error for other features.
FilteredHalves denoised_halves(const HalfPictures& noisy, const std::function<bool()>& is_stopped = {});

/// The picture of both: their mean. Never negative.
Image picture_of(const FilteredHalves& halves, const Plane& second_weight);

}  // namespace twinray
