// SPDX-License-Identifier: Apache-2.0
// The hashes that random numbers are made by: constants and finalizers, part of the image format of a seed.
#pragma once
#include <cstdint>

namespace twinray {

/// The finalizer of SplitMix64 (Steele, Lea and Flood 2014), a bijection.
inline constexpr std::uint64_t mix_factors[2] = {0xbf58476d1ce4e5b9u, 0x94d049bb133111ebu};
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * mix_factors[0];
  x = (x ^ (x >> 27)) * mix_factors[1];
  return x ^ (x >> 31);
}

// Odd steps between the inputs of `mix`, one for each kind of input.
inline constexpr std::uint64_t hash_step = 0x9e3779b97f4a7c15u;
inline constexpr std::uint64_t vertex_step = 0xd6e8feb86659fd93u;
inline constexpr std::uint64_t index_step = 0xa0761d6478bd642fu;
inline constexpr std::uint64_t stream_step = 0xe7037ed1a0b428dbu;

/// A nested scramble of reversed words: Laine and Karras 2011, with the constants of Vegdahl 2021.
inline constexpr std::uint32_t scramble_factors[3] = {0x3d20adeau, 0x05526c56u, 0x53a22864u};
constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x ^= x * scramble_factors[0];
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * scramble_factors[1];
  return x ^ (x * scramble_factors[2]);
}

}  // namespace twinray
