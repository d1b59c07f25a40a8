// SPDX-License-Identifier: Apache-2.0
#include "io/generated/noise.h"

#include <cmath>
#include <cstdint>

#include "core/random.h"

namespace twinray::generated {
namespace {

float at_corner(int x, int y, int z, unsigned seed) {
  constexpr std::uint64_t bits = (1u << 21) - 1;
  const std::uint64_t cell =
      (std::uint64_t(x) & bits) << 42 | (std::uint64_t(y) & bits) << 21 | (std::uint64_t(z) & bits);
  return Random(cell ^ (std::uint64_t(seed) * 0xd1342543de82ef95u)).uniform(-1, 1);
}

float smooth(float t) { return t * t * (3 - 2 * t); }

float blend(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace

float noise(const Vec3& p, unsigned seed) {
  const float fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const int x = int(fx), y = int(fy), z = int(fz);
  const float s = smooth(p.x - fx), t = smooth(p.y - fy), r = smooth(p.z - fz);
  float plane[2];
  for (int k = 0; k < 2; ++k) {
    const float low = blend(at_corner(x, y, z + k, seed), at_corner(x + 1, y, z + k, seed), s);
    const float high = blend(at_corner(x, y + 1, z + k, seed), at_corner(x + 1, y + 1, z + k, seed), s);
    plane[k] = blend(low, high, t);
  }
  return blend(plane[0], plane[1], r);
}

float fractal_noise(const Vec3& p, int octaves, unsigned seed) {
  float sum = 0, size = 1, frequency = 1;
  for (int i = 0; i < octaves; ++i, size *= 0.5f, frequency *= 2)
    sum += size * noise(p * frequency, seed + unsigned(i));
  return sum;
}

float ground_height(float x, float z, unsigned seed) {
  return 0.9f * fractal_noise({0.07f * x, 0, 0.07f * z}, 4, seed);
}

}  // namespace twinray::generated
