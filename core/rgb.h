// SPDX-License-Identifier: Apache-2.0
// Colours: linear radiance, reflectance or power, three channels (the primaries of sRGB).
#pragma once
#include <algorithm>
#include <cmath>

namespace twinray {

struct Rgb {
  float r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

inline constexpr Rgb white{1, 1, 1};

constexpr Rgb operator+(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Rgb operator*(const Rgb& a, const Rgb& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(const Rgb& a, float s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Rgb operator*(float s, const Rgb& a) { return a * s; }
constexpr Rgb operator/(const Rgb& a, float s) { return {a.r / s, a.g / s, a.b / s}; }
constexpr Rgb& operator+=(Rgb& a, const Rgb& b) { return a = a + b; }

constexpr bool is_black(const Rgb& c) { return c.r == 0 && c.g == 0 && c.b == 0; }
constexpr bool is_grey(const Rgb& c) { return c.r == c.g && c.r == c.b; }
/// Each component, or what is next to it in [0, 1].
constexpr Rgb within_unit(const Rgb& c) {
  return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)};
}
/// Each component, or 0 where it is less.
constexpr Rgb at_least_zero(const Rgb& c) {
  return {std::max(c.r, 0.0f), std::max(c.g, 0.0f), std::max(c.b, 0.0f)};
}
constexpr float max_component(const Rgb& c) { return std::max(c.r, std::max(c.g, c.b)); }
inline bool is_finite(const Rgb& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

/// Relative luminance of linear sRGB (ITU-R BT.709).
constexpr float luminance(const Rgb& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

}  // namespace twinray
