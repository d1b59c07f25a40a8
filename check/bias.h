// SPDX-License-Identifier: Apache-2.0
// Whether an estimator has another mean than a converged picture: Welch's test, tile by tile (A. Jung, J.
// Hanika and C. Dachsbacher, "Detecting Bias in Monte Carlo Renderers using Welch's t-test", JCGT 2020).
//
// A picture's noise hides a small bias in each pixel, but it averages out over a tile. We depart from the
// paper in what the noise is measured by: not by the variance of a pixel's samples, which overstates it
// where they are stratified, but by what differs from seed to seed. Pixels are independent of each other.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "check/picture_error.h"
#include "check/welch.h"
#include "core/image.h"

namespace twinray {

/// Pictures of one estimator that differ in their seeds alone: of each pixel's luminance the mean and its
/// variance (Welford, 1962).
class PictureMoments {
 public:
  /// Throws Error unless all have the same size.
  void add(const Image& picture);
  std::size_t count() const { return count_; }
  /// The mean over all pictures, of which there are two at least.
  MeanEstimate pixel(std::size_t index) const;

 private:
  struct Moments {
    double mean = 0, squares = 0;
  };
  std::size_t count_ = 0;
  std::vector<Moments> pixels_;
};

/// Pixels whose mean luminances are compared.
struct TileTest {
  PixelRect tile;
  std::size_t pixels = 0;  ///< That count.
  MeanEstimate picture, converged;
  WelchTest test;
};

struct BiasTest {
  TileTest whole;               ///< The bias of the picture's mean.
  std::vector<TileTest> tiles;  ///< Row by row; those in which some pixel counts.
  /// Of the least p-value of the tiles and the whole, corrected for the number of these tests.
  double p_value = 1;
};

/// The chance to find a difference in some tile, or over all, where there is none.
inline constexpr double test_level = 0.01;
/// Whether a tile differs by more than noise, at that level for all tests of the picture together.
bool is_rejected(const WelchTest& one, const BiasTest& all);

/// What is known of each pixel's mean luminance, by its index.
using PixelMeans = std::function<MeanEstimate(std::size_t)>;

/// Pixels of a frame, and which of them count.
struct MaskedFrame {
  int width = 0, height = 0;
  const PixelMask& mask;
};

/// Whether a picture has other means than another one, tile by tile and over all. Throws Error unless the
/// mask has the size of the frame.
BiasTest test_means(const PixelMeans& picture, const PixelMeans& converged, const MaskedFrame& frame,
                    int tile_edge = 16);

/// Where the noise of the converged picture is not known it counts as exact: what it has, then, is taken for
/// bias. Throws Error unless there are two pictures at least, and all have the same size.
BiasTest test_bias(const PictureMoments& pictures, const ConvergedPicture& converged, const PixelMask& mask,
                   int tile_edge = 16);

}  // namespace twinray
