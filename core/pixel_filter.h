// SPDX-License-Identifier: Apache-2.0
// How a pixel weighs the light around its middle.
#pragma once
#include <string>

#include "core/vec.h"

namespace twinray {

enum class FilterKind {
  box,              ///< All within the radius alike.
  triangle,         ///< Falls to 0 linearly.
  gaussian,         ///< exp(-x^2 / (2 sigma^2)), lowered so that it ends at 0.
  blackman_harris,  ///< The window of four cosines (Harris, 1978).
  mitchell,         ///< Cubic, negative towards the edge: sharper (Mitchell and Netravali, 1988).
};

/// A filter is the product of one function of x and one of y, both symmetric about the pixel's middle.
struct PixelFilter {
  FilterKind kind = FilterKind::box;
  Vec2 radius{0.5f, 0.5f};           ///< Where it ends, in pixels.
  float sigma = 0.5f;                ///< Of a Gaussian, in pixels; > 0.
  float b = 1.0f / 3, c = 1.0f / 3;  ///< Of Mitchell's, in [0, 1].
  friend bool operator==(const PixelFilter&, const PixelFilter&) = default;
};

/// The radii that a filter may have.
inline constexpr float least_filter_radius = 0.1f, most_filter_radius = 16;

/// Throws Error for a radius or a parameter out of range.
void check(const PixelFilter& filter);

/// "box", "triangle", "gaussian", "blackman-harris", "mitchell".
std::string filter_name(FilterKind kind);
/// The filter of this kind, with its usual radius: 0.5, 1, 1.5, 1.5 and 2 pixels.
PixelFilter usual_filter(FilterKind kind);
/// The same with another radius; a Gaussian's sigma is a third of it.
PixelFilter filter_of_radius(FilterKind kind, float radius);
/// "gaussian:1.5", and "gaussian:1.5x2" where the radii differ.
std::string filter_text(const PixelFilter& filter);

/// The filter along one axis, at x pixels from the middle, up to a factor; 0 beyond the radius.
double filter_value(const PixelFilter& filter, double radius, double x);

}  // namespace twinray
