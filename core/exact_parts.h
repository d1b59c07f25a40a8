// SPDX-License-Identifier: Apache-2.0
// Parts of a number that add up to it exactly, made of parts that were rounded: the largest of them takes
// what the others leave.
#pragma once
#include <span>

namespace twinray {

/// Parts of a whole in floats, each a multiple of the whole's last bit: so they give the whole when they are
/// added up in floats, in whatever order. Where some parts are negative and others are not, as a pixel
/// filter with negative values may have them, they need not be multiples of it, and give the whole up to the
/// rounding of the largest of them.
void make_exact(float whole, std::span<float> parts);

}  // namespace twinray
