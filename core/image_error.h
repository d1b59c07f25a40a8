// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/image.h"

namespace twinray {

/// A relative squared error is (x - c)^2 / (c^2 + this) of a picture x and the converged one c: so that of
/// black pixels is finite.
inline constexpr double least_relative_square = 0.01;

/// How far a picture's luminance is from a converged one's.
struct ImageError {
  double relative = 0;    ///< Root of the mean squared difference, over the mean of the converged picture.
  double brightness = 0;  ///< The mean over that of the converged picture, minus 1.
};

/// Both are 0 where the converged picture is black. Throws Error unless both pictures have the same size.
ImageError image_error(const Image& image, const Image& converged);

}  // namespace twinray
