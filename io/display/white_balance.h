// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/color_matrix.h"

namespace twinray {

/// The adaptation of linear colours after which the light of a black body of this temperature is white, of
/// the same luminance: Bradford's (Lam, 1985).
ColorMatrix white_balance(double kelvin);

}  // namespace twinray
