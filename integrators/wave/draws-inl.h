// SPDX-License-Identifier: Apache-2.0
// Private: the draws of core/sampler.h in lanes, compiled once for each instruction set.
//
// The matrices of the (0,4)-sequence need no tables here. Over a field of characteristic 2, Pascal's matrix
// of an element a, binomial(c, r) a^(c - r), is a product of steps, one for each bit k of the number of a
// digit: digits whose number has that bit add a^(2^k) times themselves to the digit 2^k before them (Lucas).
#if defined(TWINRAY_WAVE_DRAWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TWINRAY_WAVE_DRAWS_INL_H
#undef TWINRAY_WAVE_DRAWS_INL_H
#else
#define TWINRAY_WAVE_DRAWS_INL_H
#endif

#include "core/hash.h"
#include "integrators/wave/lanes-inl.h"
#include "integrators/wave/requests.h"

HWY_BEFORE_NAMESPACE();
namespace twinray::HWY_NAMESPACE {

HWY_ATTR HWY_INLINE WordLanes words(std::uint32_t a) { return hn::Set(WordTag(), a); }
HWY_ATTR HWY_INLINE LongLanes longs(std::uint64_t a) { return hn::Set(LongTag(), a); }

/// The products of the lower 32 bits.
HWY_ATTR HWY_INLINE LongLanes multiply_low(LongLanes a, LongLanes b) {
  return hn::MulEven(hn::BitCast(WordTag(), a), hn::BitCast(WordTag(), b));
}
HWY_ATTR HWY_INLINE LongLanes multiply(LongLanes a, std::uint64_t factor) {
  const LongLanes b = longs(factor), b_high = longs(factor >> 32);
  const LongLanes cross = hn::Add(multiply_low(hn::ShiftRight<32>(a), b), multiply_low(a, b_high));
  return hn::Add(multiply_low(a, b), hn::ShiftLeft<32>(cross));
}
HWY_ATTR HWY_INLINE LongLanes mixed(LongLanes x) {
  x = multiply(hn::Xor(x, hn::ShiftRight<30>(x)), mix_factors[0]);
  x = multiply(hn::Xor(x, hn::ShiftRight<27>(x)), mix_factors[1]);
  return hn::Xor(x, hn::ShiftRight<31>(x));
}
/// mix(x + step).
HWY_ATTR HWY_INLINE LongHalves mixed(const LongHalves& x, std::uint64_t step) {
  return {mixed(hn::Add(x.lower, longs(step))), mixed(hn::Add(x.upper, longs(step)))};
}

HWY_ATTR HWY_INLINE WordLanes scrambled(WordLanes x, WordLanes seed) {
  x = hn::Xor(x, hn::Mul(x, words(scramble_factors[0])));
  x = hn::Add(x, seed);
  x = hn::Mul(x, hn::Or(hn::ShiftRight<16>(seed), words(1)));
  x = hn::Xor(x, hn::Mul(x, words(scramble_factors[1])));
  return hn::Xor(x, hn::Mul(x, words(scramble_factors[2])));
}

/// The bits of each word, the last first: those of half bytes by tables, then the bytes.
HWY_ATTR HWY_INLINE WordLanes reversed(WordLanes x) {
  using Bytes = hn::Repartition<std::uint8_t, WordTag>;
  const Bytes bytes;
  alignas(16) static constexpr std::uint8_t half_byte[16] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                             1, 9, 5, 13, 3, 11, 7, 15};
  alignas(16) static constexpr std::uint8_t last_first[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                              11, 10, 9, 8, 15, 14, 13, 12};
  const WordLanes mask = words(0x0f0f0f0fu);
  const auto table = hn::LoadDup128(bytes, half_byte);
  const auto low = hn::TableLookupBytes(table, hn::BitCast(bytes, hn::And(x, mask)));
  const auto high = hn::TableLookupBytes(table, hn::BitCast(bytes, hn::And(hn::ShiftRight<4>(x), mask)));
  const WordLanes turned =
      hn::Or(hn::ShiftLeft<4>(hn::BitCast(WordTag(), low)), hn::BitCast(WordTag(), high));
  return hn::BitCast(WordTag(),
                     hn::TableLookupBytes(hn::BitCast(bytes, turned), hn::LoadDup128(bytes, last_first)));
}

/// Each digit of two bits (t, b), an element t + b w of the field {0, 1, w, w^2}, times w^power: w^2 = w + 1.
template <int power>
HWY_ATTR HWY_INLINE WordLanes times_w(WordLanes x) {
  if constexpr (power == 0) return x;
  const WordLanes mask = words(0x55555555u);
  const WordLanes t = hn::And(x, mask), b = hn::And(hn::ShiftRight<1>(x), mask), both = hn::Xor(t, b);
  return power == 1 ? hn::Or(b, hn::ShiftLeft<1>(both)) : hn::Or(both, hn::ShiftLeft<1>(t));
}
/// One step of Pascal's matrix: `digits` (a power of 2) is how far down, `mask` has the digits that move.
template <int power, int digits>
HWY_ATTR HWY_INLINE WordLanes pascal_step(WordLanes x, std::uint32_t mask) {
  return hn::Xor(x, times_w<power>(hn::ShiftRight<2 * digits>(hn::And(x, words(mask)))));
}
/// Pascal's matrix of w^power; power 0, 1 or 2. (w^power)^(2^k) is w^power and w^(2 power mod 3) by turns.
template <int power>
HWY_ATTR HWY_INLINE WordLanes pascal(WordLanes x) {
  constexpr int squared = 2 * power % 3;
  x = pascal_step<power, 1>(x, 0xccccccccu);
  x = pascal_step<squared, 2>(x, 0xf0f0f0f0u);
  x = pascal_step<power, 4>(x, 0xff00ff00u);
  return pascal_step<squared, 8>(x, 0xffff0000u);
}
/// The digit scramble of the middle dimensions, by which each pair is a (0,2)-sequence.
HWY_ATTR HWY_INLINE WordLanes digits_scrambled(WordLanes x) {
  return hn::Xor(x, hn::And(hn::ShiftRight<1>(x), words(0x55555555u)));
}

/// The upper 24 bits as numbers in [0, 1).
HWY_ATTR HWY_INLINE Lanes to_unit(WordLanes x) {
  const hn::RebindToSigned<WordTag> integers;
  return hn::Mul(hn::ConvertTo(FloatTag(), hn::BitCast(integers, hn::ShiftRight<8>(x))), splat(0x1p-24f));
}

/// Two dimensions of the points.
struct Pair {
  Lanes x, y;
};

/// Dimensions 0 and 1 of a set, or with `second` dimensions 2 and 3.
template <bool second>
HWY_ATTR HWY_INLINE Pair sobol_pair(const LongHalves& key, WordLanes index, std::uint32_t set) {
  const WordLanes order = high_words(mixed(key, (3 * set + 1) * hash_step));
  const LongHalves seeds = mixed(key, (3 * set + (second ? 3 : 2)) * hash_step);
  const WordLanes x = reversed(scrambled(reversed(index), order));
  const WordLanes a = second ? digits_scrambled(pascal<1>(x)) : x;
  const WordLanes b = second ? pascal<2>(x) : digits_scrambled(pascal<0>(x));
  return {to_unit(reversed(scrambled(a, low_words(seeds)))),
          to_unit(reversed(scrambled(b, high_words(seeds))))};
}

HWY_ATTR HWY_INLINE LongLanes independent_start(LongLanes key, LongLanes index) {
  return mixed(hn::Add(key, multiply(hn::Add(index, longs(1)), index_step)));
}
HWY_ATTR HWY_INLINE Pair independent_pair(const LongHalves& key, const LongHalves& index, std::uint32_t set,
                                          bool second) {
  const LongHalves start{independent_start(key.lower, index.lower),
                         independent_start(key.upper, index.upper)};
  const LongHalves bits = mixed(start, (2 * set + (second ? 2 : 1)) * hash_step);
  return {to_unit(low_words(bits)), to_unit(high_words(bits))};
}

/// index * parts + part; an index has 32 bits, parts 17.
HWY_ATTR HWY_INLINE LongLanes part_index(LongLanes index, const SubSample& sub) {
  return hn::Add(multiply_low(index, longs(sub.parts)), longs(sub.part));
}
/// Beyond 2^32 samples Sobol's points have another key.
HWY_ATTR HWY_INLINE LongLanes key_of_block(LongLanes key, LongLanes index) {
  const LongLanes block = hn::ShiftRight<32>(index);
  const auto is_first = hn::Eq(block, hn::Zero(LongTag()));
  return hn::IfThenElse(is_first, key, mixed(hn::Add(key, multiply(block, index_step))));
}

HWY_ATTR HWY_INLINE Pair draw_pair(LongHalves key, WordLanes index, const DrawRequest& request) {
  const std::uint32_t set = request.place.set;
  const bool second = request.place.member == 2;
  LongHalves long_index = join(index, hn::Zero(WordTag()));
  if (request.sub.stream != 0) key = mixed(key, request.sub.stream * stream_step);
  if (request.sub.parts != 1)
    long_index = {part_index(long_index.lower, request.sub), part_index(long_index.upper, request.sub)};
  if (request.kind == SamplerKind::independent) return independent_pair(key, long_index, set, second);
  if (request.sub.parts > 1)
    key = {key_of_block(key.lower, long_index.lower), key_of_block(key.upper, long_index.upper)};
  const WordLanes low = low_words(long_index);
  return second ? sobol_pair<true>(key, low, set) : sobol_pair<false>(key, low, set);
}

HWY_ATTR void draw(const Keys& pixels, const Words& index, std::size_t size, const DrawRequest& request,
                   Floats& x, Floats& y) {
  const std::uint64_t step = (request.place.vertex + std::uint64_t(1)) * vertex_step;
  for (std::size_t i = 0; i < size; i += lane_count) {
    const LongHalves pixel = join(load(pixels.low, i), load(pixels.high, i));
    const LongHalves key{hn::Add(pixel.lower, longs(step)), hn::Add(pixel.upper, longs(step))};
    const Pair pair = draw_pair(key, load(index, i), request);
    store(pair.x, x, i);
    store(pair.y, y, i);
  }
}

}  // namespace twinray::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
