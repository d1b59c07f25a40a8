// SPDX-License-Identifier: Apache-2.0
// Private: four floats at a time, by the vector types that GCC and Clang share: plain operators, one
// operation of IEEE 754 in each lane, on every processor.
#pragma once
#include <cstdint>
#include <cstring>

namespace twinray {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));

inline Float4 splat(float a) { return Float4{a, a, a, a}; }
/// Four floats from anywhere.
inline Float4 load(const float* from) {
  Float4 lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 abs(Float4 a) { return Float4(Int4(a) & 0x7fffffff); }
/// The largest of the first three lanes, in every lane; none of them is NaN.
inline Float4 largest_of_three(Float4 a) {
  return max(max(__builtin_shufflevector(a, a, 0, 0, 0, 0), __builtin_shufflevector(a, a, 1, 1, 1, 1)),
             __builtin_shufflevector(a, a, 2, 2, 2, 2));
}

/// Bit i: lane i of a comparison is true.
inline std::uint32_t mask_bits(Int4 mask) {
#ifdef __SSE__
  return std::uint32_t(__builtin_ia32_movmskps(Float4(mask)));
#else
  const Int4 bits = mask & Int4{1, 2, 4, 8};
  std::uint64_t halves[2];
  std::memcpy(halves, &bits, sizeof halves);
  const std::uint64_t both = halves[0] | halves[1];
  return std::uint32_t(both) | std::uint32_t(both >> 32);
#endif
}

}  // namespace twinray
