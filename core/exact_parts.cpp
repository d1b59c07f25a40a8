// SPDX-License-Identifier: Apache-2.0
#include "core/exact_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace twinray {
namespace {

/// Adds to the largest part what all lack.
template <typename Number>
void give_rest(Number whole, std::span<Number> parts) {
  if (parts.empty()) return;
  const auto is_smaller = [](Number a, Number b) { return (a < 0 ? -a : a) < (b < 0 ? -b : b); };
  Number rest = whole;
  for (const Number part : parts) rest -= part;
  *std::max_element(parts.begin(), parts.end(), is_smaller) += rest;
}

bool have_both_signs(std::span<const float> parts) {
  const auto [least, most] = std::minmax_element(parts.begin(), parts.end());
  return least != parts.end() && *least < 0 && *most > 0;
}

/// As far as doubles and the last bit of the largest part go.
void give_rest_in_double(float whole, std::span<float> parts) {
  std::vector<double> wide(parts.begin(), parts.end());
  give_rest(double(whole), std::span(wide));
  std::transform(wide.begin(), wide.end(), parts.begin(), [](double part) { return float(part); });
}

}  // namespace

void make_exact(float whole, std::span<float> parts) {
  if (have_both_signs(parts)) return give_rest_in_double(whole, parts);
  // In multiples of the whole's last bit all numbers are whole ones below 2^24, which floats hold exactly.
  const float last_bit = std::fabs(std::nextafter(whole, 2 * whole) - whole);
  if (!(last_bit > 0)) return std::fill(parts.begin(), parts.end(), 0.0f);
  for (float& part : parts) part = std::nearbyint(part / last_bit) * last_bit;
  give_rest(whole, parts);
}

}  // namespace twinray
