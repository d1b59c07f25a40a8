// SPDX-License-Identifier: Apache-2.0
#include "core/filter_sampler.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace twinray {
namespace {

/// Where the filter becomes negative, or else its radius. It changes its sign once at most: Mitchell's outer
/// piece is (2 - x)^2 times a linear function.
double end_of_inner_lobe(const PixelFilter& filter, double radius) {
  if (filter.kind != FilterKind::mitchell || filter.c == 0) return radius;
  double positive = radius / 4, negative = radius * (1 - 1e-6);
  if (filter_value(filter, radius, negative) >= 0) return radius;
  while (negative - positive > radius * 1e-15) {
    const double middle = (positive + negative) / 2;
    (filter_value(filter, radius, middle) > 0 ? positive : negative) = middle;
  }
  return positive;
}

/// The integral of |f| from `begin` to each of `cells` equal steps up to `end`, by Simpson's rule.
std::vector<double> cumulative(const PixelFilter& filter, double radius, double begin, double end) {
  constexpr std::size_t cells = 4096;
  const double step = (end - begin) / cells;
  const auto value = [&](double i) {
    return std::fabs(filter_value(filter, radius, std::min(begin + i * step, radius)));
  };
  std::vector<double> sums{0};
  for (std::size_t i = 0; i < cells; ++i) {
    const double at = double(i);
    sums.push_back(sums.back() + step / 6 * (value(at) + 4 * value(at + 0.5) + value(at + 1)));
  }
  return sums;
}

/// Cuts [begin, end] where the integral is that of the header.
void set_quantiles(const std::vector<double>& sums, double begin, double end, std::span<float> quantiles) {
  const std::size_t cells = sums.size() - 1, parts = quantiles.size() - 1;
  std::size_t cell = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    const double left = 1 - double(i) / double(parts), sum = sums.back() * (1 - left * left);
    while (cell + 1 < cells && sums[cell + 1] <= sum) ++cell;
    const double within = (sum - sums[cell]) / (sums[cell + 1] - sums[cell]);
    quantiles[i] = float(begin + (end - begin) * (double(cell) + within) / double(cells));
  }
  quantiles[parts] = float(end);
}

const PixelFilter& checked(const PixelFilter& filter) {
  check(filter);
  return filter;
}

}  // namespace

float FilterSampler::Lobe::at(float t) const {
  const float place = (1 - std::sqrt(1 - t)) * float(steps);
  const std::size_t i = std::min(std::size_t(place), steps - 1);
  return quantiles[i] + (quantiles[i + 1] - quantiles[i]) * (place - float(i));
}

FilterSampler::Axis::Axis(const PixelFilter& filter, double end)
    : is_box(filter.kind == FilterKind::box), radius(float(end)) {
  if (is_box) return;
  const double middle = end_of_inner_lobe(filter, end);
  const std::vector<double> positive = cumulative(filter, end, 0, middle);
  set_quantiles(positive, 0, middle, inner.quantiles);
  if (middle == end) return;
  const std::vector<double> negative = cumulative(filter, end, middle, end);
  set_quantiles(negative, middle, end, outer.quantiles);
  const double all = positive.back() + negative.back();
  inner.share = float(positive.back() / all);
  outer.share = 1 - inner.share;
  total = float(all / (positive.back() - negative.back()));
}

/// Folded about the middle: v is the distance from it, as a share of the integral.
float FilterSampler::Axis::sample(float u, float& weight) const {
  if (is_box) return (0.5f - radius) + 2 * radius * u;  // With the usual radius it is u, to the last bit.
  const float v = std::fabs(2 * u - 1);
  const bool is_inner = outer.share == 0 || v < inner.share;
  const float distance = is_inner ? inner.at(v / inner.share) : outer.at((v - inner.share) / outer.share);
  weight *= is_inner ? total : -total;
  return u < 0.5f ? 0.5f - distance : 0.5f + distance;
}

FilterSampler::FilterSampler(const PixelFilter& filter)
    : x_(checked(filter), double(filter.radius.x)), y_(filter, double(filter.radius.y)) {}

FilterSampler::Place FilterSampler::place(Vec2 u) const {
  float weight = 1;
  const float x = x_.sample(u.x, weight);
  const float y = y_.sample(u.y, weight);
  return {{x, y}, weight};
}

}  // namespace twinray
