// SPDX-License-Identifier: Apache-2.0
// How a picture's samples are spread over its pixels: more to those whose error is large, without a bias.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/film.h"
#include "core/rgb.h"

namespace twinray {

enum class Allocation {
  even,   ///< Each pixel has as many samples.
  error,  ///< By SampleAllocation: as many on average.
};

/// The mean colour of each pixel of a film's window so far, row by row.
std::vector<Rgb> pixel_means(const Film& film);

/// How many samples each pixel has, by the error that the pixels around it show after a pilot, which is even.
///
/// A rule that looks at a pixel's own samples, and then decides how many more it has, gives a biased mean: it
/// keeps those that are dark by chance. So the pixels are coloured like the squares of a chessboard, and what
/// a black one has is decided by the white ones alone, and the other way round: its number of samples is
/// independent of all of them, and their mean is unbiased. (The bias of other rules: D. Kirk and J. Arvo,
/// "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991.)
class SampleAllocation {
 public:
  /// The samples of the pilot.
  static constexpr std::uint32_t pilot = 16;

  /// Of a window whose pixels have these means (pixel_means()) after half of the pilot, and after all of it.
  SampleAllocation(const PixelRect& window, std::span<const Rgb> half, std::span<const Rgb> whole);

  /// How many a pixel of the window has where an even picture has n: n itself up to the pilot. Never fewer
  /// for a larger n; at most Film::max_samples.
  std::uint32_t samples_of(int x, int y, std::uint32_t n) const;

 private:
  PixelRect window_;
  std::vector<float> rates_;  ///< Samples of each pixel after the pilot, to one of an even picture.
};

}  // namespace twinray
