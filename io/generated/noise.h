// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/vec.h"

namespace twinray::generated {

/// Smooth noise in [-1, 1]: random numbers at the integer points of space (a function of the seed alone),
/// blended between them. Coordinates up to 2^20.
float noise(const Vec3& p, unsigned seed);

/// The sum of octaves of noise, each of twice the frequency of the one before and half of its size; in
/// (-2, 2).
float fractal_noise(const Vec3& p, int octaves, unsigned seed);

/// The height of gentle hills at a place; below 2.
float ground_height(float x, float z, unsigned seed);

}  // namespace twinray::generated
