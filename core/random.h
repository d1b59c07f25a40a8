// SPDX-License-Identifier: Apache-2.0
// Seeded random numbers for checks and tests, the same on every machine: splitmix64 (Steele, Lea and Flood,
// 2014). Pictures take theirs from core/sampler.h.
#pragma once
#include <cmath>
#include <cstdint>

#include "core/vec.h"

namespace twinray {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// Number `index` of the streams of a seed; for checks that any thread may take up anywhere.
  Random(std::uint64_t seed, std::uint64_t index)
      : state_(Random(seed).bits() ^ index * 0xd1342543de82ef95u) {
    state_ = bits();
  }

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// Uniform in {0, ..., count - 1}, but for a bias of count / 2^64.
  int below(int count) { return int(bits() % std::uint64_t(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  /// Uniform in [0, 1).
  float unit() { return float(bits() >> 40) * 0x1p-24f; }
  /// Uniform in [low, high].
  float uniform(float low, float high) { return low + (high - low) * unit(); }
  /// A point of the cube [-size, size]^3; each component from a draw of its own.
  Vec3 in_cube(float size = 1) {
    const float x = uniform(-size, size);
    const float y = uniform(-size, size);
    const float z = uniform(-size, size);
    return {x, y, z};
  }
  /// Uniform in the unit ball, never zero.
  Vec3 in_ball() {
    Vec3 p;
    do p = in_cube();
    while (!(length_squared(p) <= 1 && length_squared(p) > 0x1p-20f));
    return p;
  }

 private:
  std::uint64_t state_;
};

}  // namespace twinray
