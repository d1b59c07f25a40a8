// SPDX-License-Identifier: Apache-2.0
// Private: which of several filters is best, and where.
//
// The halves are filtered apart. Let a and b be a pixel's colours in the halves, and F(a), F(b) what a filter
// makes of them. Its bias shows in both, its noise in one: (F(a) - a) (F(b) - b) is the squared bias on
// average, and (F(a) - F(b))^2 / 4 the variance that is left of the mean. The same of two filters, one in
// each factor, gives the error of every mixture of them. The noisy picture itself is among the filters, with
// no bias: as noise vanishes, it alone remains.
#pragma once
#include <array>

#include "integrators/denoise/half_pictures.h"

namespace twinray {

/// Of each half the mixture with the least estimated relative squared error around each pixel, of the noisy
/// halves and two filters of them.
FilteredHalves best_blend(const HalfPictures& noisy, const std::array<FilteredHalves, 2>& filtered);

}  // namespace twinray
