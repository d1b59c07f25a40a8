// SPDX-License-Identifier: Apache-2.0
#include "check/flip_color.h"

#include <bit>
#include <cstdint>

namespace twinray::flip {
namespace {

struct Xyz {
  float x, y, z;
};

/// From the chromaticities of sRGB's primaries; each row's sum is its divisor, so that white is (1, 1, 1).
Xyz xyz_of(const Rgb& c) {
  return {(10135552.0f * c.r + 8788810.0f * c.g + 4435075.0f * c.b) / 23359437.0f,
          (2613072.0f * c.r + 8788810.0f * c.g + 887015.0f * c.b) / 12288897.0f,
          (1425312.0f * c.r + 8788810.0f * c.g + 70074185.0f * c.b) / 80288307.0f};
}

/// The inverse.
Rgb rgb_of(const Xyz& c) {
  return {3.080341988f * c.x - 1.537398969f * c.y - 0.542943019f * c.z,
          -0.921178396f * c.x + 1.875929984f * c.y + 0.045248412f * c.z,
          0.052881293f * c.x - 0.204011206f * c.y + 1.151129913f * c.z};
}

/// Relative error below 2^-22: a guess by the exponent, and two of E. Halley's steps.
float cube_root(float x) {
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) / 3 + 709921077u);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

/// CIE's curve of lightness: a cube root, with a straight line near black.
float lightness_curve(float x) {
  constexpr float delta = 6.0f / 29;
  return x > delta * delta * delta ? cube_root(x) : x / (3 * delta * delta) + 4.0f / 29;
}

// The curve is (a x^2 + b x) / (c x^2 + d x + e), with 0.6 as exposure.
constexpr double a = 0.36 * 2.51, b = 0.6 * 0.03, c = 0.36 * 2.43, d = 0.6 * 0.59, e = 0.14;

float tone_curve(double x) {
  const double tone = (a * x * x + b * x) / (c * x * x + d * x + e);
  return float(std::min(tone, 1.0));
}

}  // namespace

Opponent opponent_of(const Rgb& linear) {
  const Xyz xyz = xyz_of(linear);
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

Rgb linear_of(const Opponent& color) {
  const float y = (color.y + 16) / 116;
  return rgb_of({y + color.cx / 500, y, y - color.cz / 200});
}

HuntLab hunt_lab_of(const Rgb& linear) {
  const Xyz xyz = xyz_of(linear);
  const float x = lightness_curve(xyz.x), y = lightness_curve(xyz.y), z = lightness_curve(xyz.z);
  const float lightness = 116 * y - 16;
  return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

float distance(const HuntLab& one, const HuntLab& other) {
  const float da = one.a - other.a, db = one.b - other.b;
  return std::abs(one.lightness - other.lightness) + std::sqrt(da * da + db * db);
}

Rgb clipped(const Rgb& linear) {
  const auto clip = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
  return {clip(linear.r), clip(linear.g), clip(linear.b)};
}

Rgb tone_mapped(const Rgb& radiance) {
  constexpr float most = 1e9f;  // Its square is a number, and its tone that of anything brighter.
  const auto tone = [&](float x) { return tone_curve(std::min(x, most)); };
  return {tone(radiance.r), tone(radiance.g), tone(radiance.b)};
}

double radiance_of_bright_tone() {
  constexpr double tone = 0.85;  // Andersson et al. 2021
  const double half = 0.5 * (b - d * tone) / (a - c * tone), last = -e * tone / (a - c * tone);
  return std::sqrt(half * half - last) - half;
}

}  // namespace twinray::flip
