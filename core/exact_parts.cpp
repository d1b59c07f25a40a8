// SPDX-License-Identifier: Apache-2.0
#include "core/exact_parts.h"

#include <algorithm>
#include <cmath>

namespace twinray {
namespace {

/// Adds to the largest part what all lack.
template <typename Number>
void give_rest(Number whole, std::span<Number> parts) {
  if (parts.empty()) return;
  Number rest = whole;
  for (const Number part : parts) rest -= part;
  *std::max_element(parts.begin(), parts.end()) += rest;
}

}  // namespace

void make_exact(Int128 whole, std::span<Int128> parts) { give_rest(whole, parts); }

void make_exact(float whole, std::span<float> parts) {
  // In multiples of the whole's last bit all numbers are whole ones below 2^24, which floats hold exactly.
  const float last_bit = std::nextafter(whole, 2 * whole) - whole;
  if (!(last_bit > 0)) return std::fill(parts.begin(), parts.end(), 0.0f);
  for (float& part : parts) part = std::nearbyint(part / last_bit) * last_bit;
  give_rest(whole, parts);
}

}  // namespace twinray
