// SPDX-License-Identifier: Apache-2.0
#include "cli/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/compare/pixel_noise.h"
#include "cli/finite_picture.h"
#include "cli/frame_part.h"
#include "core/error.h"
#include "core/memory.h"
#include "io/picture/image_file.h"

namespace twinray::compare {
namespace {

constexpr std::size_t listed_tiles = 8;

void check_sizes(const Comparison& pair) {
  const Image &a = pair.picture, &b = pair.reference;
  if (a.width != b.width || a.height != b.height)
    throw Error(fmt::format("{} has {} x {} pixels, {} {} x {}: only pictures of one size are compared",
                            pair.picture_name, a.width, a.height, pair.reference_name, b.width, b.height));
}

void check_parts(const Comparison& pair) {
  const auto a = part_shown(pair.picture_name, pair.picture),
             b = part_shown(pair.reference_name, pair.reference);
  if (a && b && *a != *b)
    throw Error(fmt::format("{} shows {}, {} {}: only pictures of one part of a frame are compared",
                            pair.picture_name, frame_part_text(*a), pair.reference_name,
                            frame_part_text(*b)));
}

/// What FLIP keeps of both pictures, and the map.
void check_room(const Image& image) {
  constexpr std::uint64_t bytes_a_pixel = 120;
  const MemoryNeed need{"the comparison", bytes_a_pixel * image.pixels.size()};
  check_memory({&need, 1});
}

/// What is left of radiance on a display.
void clip(Image& image) {
  for (Rgb& pixel : image.pixels) pixel = within_unit(pixel);
}

/// Without variances of both there is no test.
std::optional<BiasTest> test_noise(const Comparison& pair) {
  const PixelNoise a = read_pixel_noise(pair.picture_name), b = read_pixel_noise(pair.reference_name);
  if (!a.is_known() || !b.is_known()) return std::nullopt;
  const PixelMask mask = pixels_with_noise(a, b);
  if (std::count(mask.begin(), mask.end(), 1) == 0) return std::nullopt;
  return test_means([&](std::size_t i) { return a.estimate(pair.picture.pixels[i], i); },
                    [&](std::size_t i) { return b.estimate(pair.reference.pixels[i], i); },
                    {pair.reference.width, pair.reference.height, mask});
}

}  // namespace

Comparison compare(const std::string& picture, const std::string& reference) {
  Comparison result;
  result.picture_name = picture;
  result.reference_name = reference;
  result.picture = read_finite_image(picture);
  result.reference = read_finite_image(reference);
  result.is_radiance = holds_radiance(picture) && holds_radiance(reference);
  check_sizes(result);
  check_parts(result);
  check_room(result.reference);
  if (!result.is_radiance) {
    clip(result.picture);
    clip(result.reference);
  }
  result.difference = picture_difference(result.picture, result.reference);
  result.tiles = largest_differences(result.picture, result.reference, listed_tiles);
  if (!result.is_radiance)
    result.psnr = peak_signal_to_noise(encode_srgb(result.picture), encode_srgb(result.reference));
  result.flip =
      (result.is_radiance ? hdr_flip : ldr_flip)(result.picture, result.reference, usual_pixels_per_degree);
  result.mean_flip = mean_of(result.flip);
  result.largest_flip = *std::max_element(result.flip.values.begin(), result.flip.values.end());
  if (result.is_radiance) result.test = test_noise(result);
  return result;
}

double value_of(const Comparison& comparison, Measure measure) {
  const SquaredError& squared = comparison.difference.all.squared;
  switch (measure) {
    case Measure::mse:
      return squared.mse;
    case Measure::rmse:
      return std::sqrt(squared.mse);
    case Measure::relative_mse:
      return squared.relative;
    default:
      return comparison.mean_flip;
  }
}

}  // namespace twinray::compare
