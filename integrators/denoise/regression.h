// SPDX-License-Identifier: Apache-2.0
// Private: each pixel by what its neighbours say of it (B. Bitterli, F. Rousselle, B. Moon, J. A.
// Iglesias-Guitian, D. Adler, K. Mitchell, W. Jarosz and J. Novak, "Nonlinearly Weighted First-order
// Regression for Denoising Monte Carlo Renderings", EGSR 2016).
//
// Around a pixel p, colours are taken to be linear in the features: c(q) = a + B (f(q) - f(p)). Neighbours
// that look alike count more, and the least squares give a, the pixel's new colour. So an edge that the
// features show stays sharp, and so does a texture; what is noise has no feature and goes.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "integrators/denoise/color_planes.h"
#include "integrators/denoise/patch_distance.h"
#include "integrators/denoise/tile.h"

namespace twinray {

/// Albedo and normal: three numbers each.
inline constexpr std::size_t feature_count = 6;
/// The bandwidths of the filters that compete: the factor k of a difference that still counts as alike.
inline constexpr std::array<float, 2> bandwidths{0.5f, 1.0f};

/// What all pixels' regressions see.
struct RegressionInput {
  std::vector<PaddedPlane> color;     ///< Three channels that are to be filtered.
  std::vector<PaddedPlane> features;  ///< feature_count.
  std::vector<PaddedPlane> feature_variance;
  PaddedPlane inside;  ///< 1 within the picture, else 0.
  Guide guide;         ///< Independent of the colours' noise.
};

/// The colours by each of the bandwidths. Pixels that it has not come to when `is_stopped` says true stay
/// black.
std::array<Color, bandwidths.size()> regressions(const RegressionInput& input, int width, int height,
                                                 const std::function<bool()>& is_stopped);

}  // namespace twinray
