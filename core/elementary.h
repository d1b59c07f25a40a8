// SPDX-License-Identifier: Apache-2.0
// Elementary functions of our own: the library's differ in their last bits from machine to machine, and
// whatever reaches a pixel or a decision must not. Each states its largest error over its range, and a test
// holds it to that.
#pragma once
#include <bit>
#include <cstdint>

namespace twinray {

inline constexpr double turns_per_radian = 0.15915494309189534;

struct SinCos {
  float sin, cos;
};

/// Sine and cosine of 2 pi turns, turns in [0, 1]. Absolute error below 2^-23; exact, without a -0, at the
/// quarter turns.
inline SinCos sincos_turns(float turns) {
  const int quadrant = int(turns * 4 + 0.5f);
  const float x = (turns - 0.25f * float(quadrant)) * 6.28318530717958647692f;  // The difference is exact.
  const float z = x * x;
  const float sine = x + x * z * (-1.0f / 6 + z * (1.0f / 120 + z * (-1.0f / 5040 + z * (1.0f / 362880))));
  const float cosine = 1 - (0.5f * z - z * z * (1.0f / 24 + z * (-1.0f / 720 + z * (1.0f / 40320))));
  // 0 - x and not -x: it has no -0.
  switch (quadrant & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, 0 - sine};
    case 2:
      return {0 - sine, 0 - cosine};
    default:
      return {0 - cosine, sine};
  }
}

/// e^x. Relative error below 2^-22 for x in [-87, 88]; 0 below, and as at 88 above.
inline float exp_of(float x) {
  if (!(x >= -87)) return 0;
  const float bounded = x < 88 ? x : 88;
  const int power = int(bounded * 1.44269504f + (bounded < 0 ? -0.5f : 0.5f));
  // ln 2 in two parts, so that the first product is exact.
  const float r = (bounded - float(power) * 0.693359375f) + float(power) * 2.12194440e-4f;
  const float tail =
      0.5f + r * (0.16666598f + r * (0.0416665035f + r * (0.00835987286f + r * 0.00139295951f)));
  return (1 + (r + r * r * tail)) * std::bit_cast<float>(std::uint32_t(power + 127) << 23);
}

/// A normal x > 0 is e^series 2^power, series in ln 2 [-1/2, 1/2]; 0 for a power of two.
struct PowerOf2 {
  float power, series;

  explicit PowerOf2(float x) {
    // x = m 2^power with m in [sqrt(1/2), sqrt(2)); log(m) = 2 atanh((m - 1) / (m + 1)).
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t shift = (bits - 0x3f3504f3u) & 0xff800000u;
    const float m = std::bit_cast<float>(bits - shift);
    const float s = (m - 1) / (m + 1), z = s * s;
    power = float(std::int32_t(shift) >> 23);
    series = 2 * s + 2 * s * z * (1.0f / 3 + z * (1.0f / 5 + z * (1.0f / 7 + z * (1.0f / 9))));
  }
};

/// The natural logarithm of a normal x > 0. Relative error below 2^-21.
inline float log_of(float x) {
  const PowerOf2 of(x);
  return of.power * 0.693147181f + of.series;
}

/// The logarithm to base 2 of a normal x > 0, exact for powers of two. Relative error below 2^-21.
inline float short_log2_of(float x) {
  const PowerOf2 of(x);
  return of.power + of.series * 1.44269504f;
}

/// The complementary error function of x >= 0. Absolute error below 2^-21.
inline float erfc_of(float x) {
  const float t = 1 / (1 + 0.3275911f * x);
  const float series =
      0.18481207f +
      t * (0.184556006f +
           t * (0.183661286f +
                t * (0.0905037280f +
                     t * (0.346487486f + t * (-0.306111573f + t * (0.446947452f + t * -0.130856481f))))));
  return t * series * exp_of(-x * x);
}

/// In double, for set-up work (cameras, scene files). |x| up to 10^4 radians, NaN beyond. Relative error
/// below 4e-16 for sine and cosine, 8e-16 for the tangent, also beside their zeros and poles.
double sin_radians(double x);
double cos_radians(double x);
double tan_radians(double x);

/// The angle of the point (x, y), counter-clockwise from +x, in turns in [0, 1]: absolute error below 2e-16.
/// The origin has the angle 0.
double atan2_turns(double y, double x);

/// log2 of a finite x > 0: relative error below 2e-16. -infinity at 0, NaN below.
double log2_of(double x);
/// 2^x for finite x: relative error below 2e-16 in [-1000, 1000]. Beyond, down to 0 and up to infinity.
double exp2_of(double x);
/// x^y for finite x >= 0 and finite y: relative error below 8e-15 where the result lies in [2^-1000, 2^1000];
/// beyond, down to 0 and up to infinity. 0^0 is 1, 0^y is 0 for y > 0 and infinity for y < 0. NaN for x < 0.
double pow_of(double x, double y);

}  // namespace twinray
