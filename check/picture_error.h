// SPDX-License-Identifier: Apache-2.0
// How far a picture is from a converged one that has noise of its own.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/image.h"
#include "core/image_error.h"

namespace twinray {

/// For each pixel whether it counts.
using PixelMask = std::vector<std::uint8_t>;

/// What others are compared with.
struct ConvergedPicture {
  Image mean;
  /// What is known of its noise: half the difference of two independent halves, whose square is, pixel by
  /// pixel and on average, the variance of the mean. None where only the picture is known.
  std::optional<Image> noise;
};

/// Of two independent pictures with the same number of samples.
ConvergedPicture converged_picture(const Image& a, const Image& b);

/// Means over the pixels that count and over the three channels of linear radiance.
struct SquaredError {
  double mse = 0;  ///< (x - c)^2 of a picture x and the converged one c
  double relative =
      0;  ///< (x - c)^2 / (c^2 + 0.01): dark parts count like bright ones (Rousselle et al. 2011).
};

/// A difference's part of the relative error.
inline double relative_square(double difference, double converged) {
  return difference * difference / (converged * converged + least_relative_square);
}

/// The converged picture's own noise included. Zeros where no pixel counts. Throws Error unless pictures and
/// mask have the same size.
SquaredError squared_error(const Image& image, const ConvergedPicture& converged, const PixelMask& mask);

/// The converged picture's own part of every such error; zeros where its noise is not known.
SquaredError own_error(const ConvergedPicture& converged, const PixelMask& mask);

}  // namespace twinray
