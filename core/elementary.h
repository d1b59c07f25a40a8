// SPDX-License-Identifier: Apache-2.0
// Elementary functions of our own: the library's differ in their last bits from machine to machine, and
// whatever reaches a pixel or a decision must not. Each states its largest error over its range, and a test
// holds it to that.
#pragma once

namespace twinray {

struct SinCos {
  float sin, cos;
};

/// Sine and cosine of 2 pi turns, turns in [0, 1].
SinCos sincos_turns(float turns);

/// In double, for set-up work (cameras, scene files). |x| up to 10^4 radians.
double sin_radians(double x);
double cos_radians(double x);
double tan_radians(double x);

/// log2 of a finite x > 0; 2^x for x in [-1000, 1000].
double log2_of(double x);
double exp2_of(double x);
/// x^y for finite x >= 0 and finite y; 0^0 is 1, 0^y is 0 for y > 0.
double pow_of(double x, double y);

}  // namespace twinray
