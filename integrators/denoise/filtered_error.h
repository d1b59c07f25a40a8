// SPDX-License-Identifier: Apache-2.0
// How far a denoised picture is from the true one.
#pragma once
#include "integrators/denoise/half_pictures.h"

namespace twinray {

/// The root of the relative mean squared error (check/picture_error.h) of the mean of filtered halves, as far
/// as these and the noisy ones tell: what is left of the noise, and what the filter adds as bias (blend.h).
/// Bias that seems to be negative counts as none.
double estimated_relative_error(const HalfPictures& noisy, const FilteredHalves& filtered);

}  // namespace twinray
