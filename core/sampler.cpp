// SPDX-License-Identifier: Apache-2.0
// A set is a point of a 4D sequence with its own order of the index and its own digit scrambles (Burley
// 2020).
//
// Dimensions 0 and 1 are Sobol's first two: identity and Pascal's triangle modulo 2, a (0,2)-sequence.
// Sobol's next two are not one, so we continue instead over the field of four elements {0, 1, w, w^2}:
// matrices binomial(c, r) a^(c - r) with a = 0, 1, w, w^2 (Niederreiter 1987), each element written as 2 x 2
// bits. All four together are a (0,4)-sequence in base 4, and dimensions 2 and 3 a (0,2)-sequence in base 2
// again (as in Ahmed et al., "SZ Sequences: Binary-Based (0, 2^q)-Sequences", 2024, with matrices found by
// our own search).
//
// All words are kept with their bits reversed, the first binary digit of a number in bit 0: there a product
// carries from a digit to the later ones only, which is what a nested (Owen) scramble may do.
#include "core/sampler.h"

#include <array>
#include <cassert>

#include "core/error.h"
#include "core/hash.h"

namespace twinray {
namespace {

using Lanes = std::array<std::uint32_t, 4>;

constexpr std::uint32_t reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// Each digit of two bits (t, b) as an element t + b w of the field, times w: w^2 = w + 1.
constexpr std::uint32_t times_w(std::uint32_t x) {
  const std::uint32_t t = x & 0x55555555u, b = (x >> 1) & 0x55555555u;
  return b | ((t ^ b) << 1);
}

/// Column `number` of the matrix of a dimension, reversed: row r in bit r.
constexpr std::uint32_t matrix_column(int dimension, int number) {
  std::uint32_t column = 1u << (number % 2);
  for (int i = 0; i < number / 2; ++i) {  // Pascal's rule; multiplied by a = 0, 1, w or w^2.
    std::uint32_t product = dimension == 0 ? 0 : column;
    for (int power = 1; power < dimension; ++power) product = times_w(product);
    column = (column << 2) ^ product;
  }
  // A digit scramble that makes each pair of dimensions a (0,2)-sequence.
  const bool plain = dimension == 0 || dimension == 3;
  return plain ? column : column ^ ((column >> 1) & 0x55555555u);
}

/// table[k][v]: what the four bits v from bit 4k on of a reversed index contribute to each dimension.
using Table = std::array<std::array<Lanes, 16>, 8>;
constexpr Table make_table() {
  Table table{};
  for (int bit = 0; bit < 32; ++bit)
    for (int dimension = 0; dimension < 4; ++dimension) {
      const std::uint32_t column = matrix_column(dimension, 31 - bit);
      for (std::size_t v = 0; v < 16; ++v)
        if (v >> (bit % 4) & 1) table[std::size_t(bit / 4)][v][std::size_t(dimension)] ^= column;
    }
  return table;
}
constexpr Table table = make_table();

/// The upper 24 bits as a number in [0, 1).
float to_unit(std::uint32_t x) { return float(std::int32_t(x >> 8)) * 0x1p-24f; }

/// Two dimensions of a set, as 24-bit fractions of 32-bit words.
Vec2 to_unit(std::uint32_t x, std::uint32_t y) { return {to_unit(x), to_unit(y)}; }

Vec2 independent_pair(std::uint64_t key, std::uint64_t index, const DrawPlace& place) {
  const std::uint64_t start = mix(key + (index + 1) * index_step);
  const std::uint64_t bits = mix(start + (2 * place.set + place.member / 2 + 1) * hash_step);
  return to_unit(std::uint32_t(bits), std::uint32_t(bits >> 32));
}

Vec2 sobol_pair(std::uint64_t key, std::uint32_t index, const DrawPlace& place) {
  const std::uint64_t order = mix(key + (3 * place.set + 1) * hash_step);
  const std::uint64_t seeds = mix(key + (3 * place.set + place.member / 2 + 2) * hash_step);
  const std::uint32_t shuffled = scrambled(reversed(index), std::uint32_t(order >> 32));
  std::uint32_t x = 0, y = 0;
  for (std::size_t nibble = 0; nibble < table.size(); ++nibble) {
    const Lanes& columns = table[nibble][shuffled >> (4 * nibble) & 15];
    x ^= columns[place.member];
    y ^= columns[place.member + 1];
  }
  return to_unit(reversed(scrambled(x, std::uint32_t(seeds))),
                 reversed(scrambled(y, std::uint32_t(seeds >> 32))));
}

}  // namespace

PathKey::PathKey(const SampleKey& key)
    : pixel(mix(mix(key.seed + hash_step) + (std::uint64_t(key.y) << 32 | key.x))), index(key.index) {}

Vec2 draw_pair(SamplerKind kind, const PathKey& path, const DrawPlace& place, const SubSample& sub) {
  assert(place.member % 2 == 0 && place.member < 4);
  assert(sub.part < sub.parts && sub.parts <= 1u << 16);
  std::uint64_t key = path.pixel + (place.vertex + std::uint64_t(1)) * vertex_step;  // Mixed when it is used.
  if (sub.stream != 0) key = mix(key + sub.stream * stream_step);
  const std::uint64_t index = std::uint64_t(path.index) * sub.parts + sub.part;
  if (kind == SamplerKind::independent) return independent_pair(key, index, place);
  if (index >> 32 != 0) key = mix(key + (index >> 32) * index_step);  // A sequence has 2^32 points.
  return sobol_pair(key, std::uint32_t(index), place);
}

std::string sampler_name(SamplerKind kind) { return kind == SamplerKind::sobol ? "sobol" : "independent"; }

SamplerKind parse_sampler(const std::string& name) {
  for (const SamplerKind kind : {SamplerKind::sobol, SamplerKind::independent})
    if (name == sampler_name(kind)) return kind;
  throw Error("unknown sampler \"" + name + "\"; valid are: sobol, independent");
}

}  // namespace twinray
