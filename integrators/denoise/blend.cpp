// SPDX-License-Identifier: Apache-2.0
#include "integrators/denoise/blend.h"

#include <limits>

#include "core/parallel.h"
#include "integrators/denoise/box_mean.h"
#include "integrators/denoise/error_product.h"

namespace twinray {
namespace {

/// The noisy picture and the filters of it.
constexpr std::size_t candidates = 3;
using Candidates = std::array<FilteredHalves, candidates>;
constexpr int steps = 16;  ///< Shares of a mixture are multiples of 1 / steps.
constexpr std::size_t pixels_a_task = 4096;

/// The expected products of the errors of two candidates: lower half of a symmetric matrix.
using ErrorProducts = std::array<std::array<Plane, candidates>, candidates>;
using Shares = std::array<float, candidates>;

Candidates candidates_of(const HalfPictures& noisy, const std::array<FilteredHalves, 2>& filtered) {
  return {FilteredHalves{noisy.halves[0].color, noisy.halves[1].color}, filtered[0], filtered[1]};
}

Plane error_products(const ErrorProduct& product) {
  Plane means(product.noisy.width, product.noisy.height);
  parallel_for(means.values.size(), pixels_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      means.values[i] = (product(i, 0) + product(i, 1) + product(i, 2)) * (1.0f / 3);
  });
  return box_mean(box_mean(means, error_radius), error_radius);
}

ErrorProducts all_error_products(const HalfPictures& noisy, const Candidates& all,
                                 std::span<const Plane> level) {
  ErrorProducts products;
  for (std::size_t i = 0; i < candidates; ++i)
    for (std::size_t j = 0; j <= i; ++j) products[i][j] = error_products({noisy, all[i], all[j], level});
  return products;
}

float error_of(const Shares& shares, const ErrorProducts& products, std::size_t pixel) {
  float error = 0;
  for (std::size_t i = 0; i < candidates; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      error += (i == j ? 1.0f : 2.0f) * shares[i] * shares[j] * products[i][j].values[pixel];
  return error;
}

Shares best_shares(const ErrorProducts& products, std::size_t pixel) {
  Shares best{1, 0, 0};
  float least = std::numeric_limits<float>::infinity();
  for (int first = 0; first <= steps; ++first)
    for (int second = 0; first + second <= steps; ++second) {
      const Shares shares{float(steps - first - second) / steps, float(first) / steps, float(second) / steps};
      const float error = error_of(shares, products, pixel);
      if (error < least) {
        best = shares;
        least = error;
      }
    }
  return best;
}

}  // namespace

FilteredHalves best_blend(const HalfPictures& noisy, const std::array<FilteredHalves, 2>& filtered) {
  const Candidates all = candidates_of(noisy, filtered);
  const std::vector<Plane> level = means_of_halves(all.back()[0], all.back()[1], noisy.second_weight);
  const ErrorProducts products = all_error_products(noisy, all, level);
  FilteredHalves blend = all.front();
  parallel_for(noisy.second_weight.values.size(), pixels_a_task, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      const Shares shares = best_shares(products, pixel);
      for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t c = 0; c < 3; ++c) {
          float sum = 0;
          for (std::size_t i = 0; i < candidates; ++i) sum += shares[i] * all[i][half][c].values[pixel];
          blend[half][c].values[pixel] = sum;
        }
    }
  });
  return blend;
}

}  // namespace twinray
