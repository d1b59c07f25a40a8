// SPDX-License-Identifier: Apache-2.0
#include "check/bias.h"

#include <algorithm>

#include "check/tiles.h"
#include "core/error.h"

namespace twinray {
namespace {

MeanEstimate converged_pixel(const ConvergedPicture& converged, std::size_t index) {
  MeanEstimate one{.mean = luminance(converged.mean.pixels[index])};
  if (!converged.noise) return one;
  const double noise = luminance(converged.noise->pixels[index]);
  one.variance = noise * noise;
  one.freedom = 1;  // of two halves
  return one;
}

/// What is compared, and where.
struct Comparison {
  const PixelMeans &picture, &converged;
  const MaskedFrame& frame;
};

TileTest test_tile(const Comparison& compared, const PixelRect& tile) {
  MeanOfMeans picture, converged;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(compared.frame.width) + std::size_t(x);
      if (!compared.frame.mask[i]) continue;
      picture.add(compared.picture(i));
      converged.add(compared.converged(i));
    }
  const MeanEstimate a = picture.estimate(), b = converged.estimate();
  return {tile, picture.count(), a, b, welch_test(a, b)};
}

}  // namespace

void PictureMoments::add(const Image& picture) {
  if (count_ == 0) pixels_.resize(picture.pixels.size());
  if (pixels_.size() != picture.pixels.size()) throw Error("pictures of different sizes have no common mean");
  ++count_;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Moments& moments = pixels_[i];
    const double difference = luminance(picture.pixels[i]) - moments.mean;
    moments.mean += difference / double(count_);
    moments.squares += difference * (luminance(picture.pixels[i]) - moments.mean);
  }
}

MeanEstimate PictureMoments::pixel(std::size_t index) const {
  const auto n = double(count_);
  return {pixels_[index].mean, pixels_[index].squares / (n - 1) / n, n - 1};
}

bool is_rejected(const WelchTest& one, const BiasTest& all) {
  return corrected_p_value(one.p_value, all.tiles.size() + 1) < test_level;
}

BiasTest test_means(const PixelMeans& picture, const PixelMeans& converged, const MaskedFrame& frame,
                    int tile_edge) {
  if (frame.mask.size() != std::size_t(frame.width) * std::size_t(frame.height))
    throw Error("the mask has another size than the picture");
  const Comparison compared{picture, converged, frame};
  BiasTest result;
  result.whole = test_tile(compared, {0, 0, frame.width, frame.height});
  double least = result.whole.test.p_value;
  for (const PixelRect& tile : tiles_of(frame.width, frame.height, tile_edge)) {
    const TileTest test = test_tile(compared, tile);
    if (test.pixels == 0) continue;
    least = std::min(least, test.test.p_value);
    result.tiles.push_back(test);
  }
  result.p_value = corrected_p_value(least, result.tiles.size() + 1);
  return result;
}

BiasTest test_bias(const PictureMoments& pictures, const ConvergedPicture& converged, const PixelMask& mask,
                   int tile_edge) {
  if (pictures.count() < 2) throw Error("a test for bias needs two pictures of different seeds");
  return test_means([&](std::size_t i) { return pictures.pixel(i); },
                    [&](std::size_t i) { return converged_pixel(converged, i); },
                    {converged.mean.width, converged.mean.height, mask}, tile_edge);
}

}  // namespace twinray
