// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/color_matrix.h"
#include "core/rgb.h"

namespace twinray {

/// The adaptation of linear colours after which light of this colour is white, of the same luminance:
/// Bradford's (Lam, 1985).
ColorMatrix white_balance(const Rgb& light);

}  // namespace twinray
