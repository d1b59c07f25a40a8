// SPDX-License-Identifier: Apache-2.0
#include "core/sampler.h"

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/chi_square.h"

namespace twinray {
namespace {

constexpr SamplerKind kinds[] = {SamplerKind::sobol, SamplerKind::independent};
constexpr int dimensions = 16;  // The members of four sets, whether a purpose has them or not.

Vec2 draw_pair_at(SamplerKind kind, const SampleKey& key, std::uint32_t vertex, int dimension) {
  const auto set = std::uint32_t(dimension) / 4, member = std::uint32_t(dimension) % 4;
  return draw_pair(kind, PathKey(key), {vertex, set, member});
}
float draw(SamplerKind kind, const SampleKey& key, std::uint32_t vertex, int dimension) {
  const Vec2 pair = draw_pair_at(kind, key, vertex, dimension - dimension % 2);
  return dimension % 2 == 0 ? pair.x : pair.y;
}

/// Aligned blocks of 2^log_count samples: the whole of a small render, a later pass, and far out.
std::vector<SampleKey> blocks(int log_count) {
  return {{.seed = 1, .x = 3, .y = 4, .index = 0},
          {.seed = 1, .x = 700, .y = 2, .index = 5u << log_count},
          {.seed = 0, .x = 0, .y = 0, .index = 0xfffffc00u}};
}

/// Whether each cell (of cells[i] equal parts of dimension first + i) holds one of the block's samples.
bool one_in_each_cell(const SampleKey& start, int first, const std::vector<int>& cells) {
  std::size_t count = 1;
  for (const int parts : cells) count *= std::size_t(parts);
  std::vector<int> taken(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    SampleKey key = start;
    key.index += i;
    std::size_t cell = 0;
    for (std::size_t d = 0; d < cells.size(); ++d) {
      const float u = draw(SamplerKind::sobol, key, 2, first + int(d));
      cell = cell * std::size_t(cells[d]) + std::size_t(u * float(cells[d]));
    }
    if (taken[cell]++ != 0) return false;
  }
  return true;
}

/// Checks that pairs of draws over a region of pixels are uniform, and so independent of each other, as one
/// of `tests` of a family; a density that is off by 5.5 % would be seen.
void check_pairs(int tests,
                 const std::function<std::pair<float, float>(std::uint32_t x, std::uint32_t y)>& pair) {
  constexpr std::uint32_t side = 256;
  test::Grid grid(16, 16);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto [a, b] = pair(x, y);
      grid.add(a, b);
    }
  test::check_uniform(grid.counts(), tests, 0.055);
}

}  // namespace

TEST_CASE("every dimension of sobol is stratified over blocks of 2^k samples") {
  for (int k = 1; k <= 10; ++k)
    for (const SampleKey& start : blocks(k))
      for (int dimension = 0; dimension < dimensions; ++dimension) {
        CAPTURE(k, start.x, start.index, dimension);
        CHECK(one_in_each_cell(start, dimension, {1 << k}));
      }
}

TEST_CASE("every pair of sobol is a (0,2)-sequence in base 2") {
  for (int k = 1; k <= 10; ++k)
    for (const SampleKey& start : blocks(k))
      for (int first = 0; first < dimensions; first += 2)
        for (int split = 0; split <= k; ++split) {
          CAPTURE(k, start.x, start.index, first, split);
          CHECK(one_in_each_cell(start, first, {1 << split, 1 << (k - split)}));
        }
}

TEST_CASE("every set of sobol is a (0,4)-sequence in base 4") {
  constexpr int log_count = 8;  // 4^4 samples.
  for (const SampleKey& start : blocks(log_count))
    for (int set = 0; set < 4; ++set)
      for (int a = 0; a <= 4; ++a)
        for (int b = 0; a + b <= 4; ++b)
          for (int c = 0; a + b + c <= 4; ++c) {
            CAPTURE(start.x, start.index, set, a, b, c);
            const int d = 4 - a - b - c;
            CHECK(one_in_each_cell(start, 4 * set, {1 << 2 * a, 1 << 2 * b, 1 << 2 * c, 1 << 2 * d}));
          }
}

TEST_CASE("no two draws of a path are found in one place") {
  std::set<std::array<std::uint32_t, 3>> taken;
  const auto take = [&](Purpose purpose, std::uint32_t vertex, std::uint32_t size) {
    const DrawPlace place = place_of(purpose, vertex);
    CAPTURE(int(purpose), vertex, place.vertex, place.set, place.member);
    CHECK(place.member % size == 0);
    for (std::uint32_t i = 0; i < size; ++i)
      CHECK(taken.insert({place.vertex, place.set, place.member + i}).second);
  };
  take(Purpose::pixel, 0, 2);
  take(Purpose::lens, 0, 2);
  take(Purpose::time, 0, 1);
  for (std::uint32_t vertex = 1; vertex <= 101; ++vertex) {
    for (const Purpose pair : {Purpose::light_point, Purpose::direction, Purpose::texture})
      take(pair, vertex, 2);
    for (const Purpose one :
         {Purpose::light_pick, Purpose::lobe, Purpose::roulette, Purpose::alpha, Purpose::medium})
      take(one, vertex, 1);
  }
}

TEST_CASE("what a path depends on together is stratified together") {
  const auto share = [](Purpose a, std::uint32_t vertex_a, Purpose b, std::uint32_t vertex_b) {
    const DrawPlace first = place_of(a, vertex_a), second = place_of(b, vertex_b);
    return first.vertex == second.vertex && first.set == second.set;
  };
  CHECK(share(Purpose::pixel, 0, Purpose::light_point, 1));
  CHECK(share(Purpose::direction, 1, Purpose::direction, 2));
  CHECK(share(Purpose::light_point, 2, Purpose::light_point, 3));
  CHECK_FALSE(share(Purpose::direction, 2, Purpose::direction, 3));
}

TEST_CASE("a vertex's draws are those of their places") {
  const PathKey path(SampleKey{.seed = 7, .x = 10, .y = 20, .index = 30});
  for (const SamplerKind kind : kinds)
    for (const std::uint32_t vertex : {1u, 2u, 7u}) {
      const VertexSampler sampler(kind, path, vertex);
      CHECK(sampler.draw_2d(Purpose::direction) ==
            draw_pair(kind, path, place_of(Purpose::direction, vertex)));
      CHECK(sampler.draw_1d(Purpose::light_pick) == draw_pair(kind, path, {vertex, 2, 0}).x);
      CHECK(sampler.draw_1d(Purpose::lobe) == draw_pair(kind, path, {vertex, 2, 0}).y);
      CHECK(sampler.draw_1d(Purpose::roulette) == draw_pair(kind, path, {vertex, 2, 2}).x);
      CHECK(sampler.draw_1d(Purpose::alpha) == draw_pair(kind, path, {vertex, 2, 2}).y);
    }
}

TEST_CASE("draws are uniform multiples of 2^-24, at least 0 and below 1") {
  for (const SamplerKind kind : kinds)
    for (int d = 0; d < dimensions; ++d) {
      test::Grid grid(256, 1);
      for (std::uint32_t i = 0; i < 1 << 16; ++i) {
        const float u = draw(kind, {.seed = 3, .x = i & 255, .y = i >> 8, .index = i % 37}, d % 5, d);
        REQUIRE(u >= 0);
        REQUIRE(u < 1);
        REQUIRE(u * 0x1p24f == std::floor(u * 0x1p24f));
        grid.add(u, 0);
      }
      CAPTURE(sampler_name(kind), d);
      test::check_uniform(grid.counts(), 2 * dimensions, 0.055);
    }
}

TEST_CASE("two dimensions of a vertex are independent of each other") {
  for (const SamplerKind kind : kinds)
    for (int a = 0; a < dimensions; ++a)
      for (int b = a + 1; b < dimensions; ++b) {
        CAPTURE(sampler_name(kind), a, b);
        check_pairs(dimensions * (dimensions - 1), [&](auto x, auto y) {
          const SampleKey key = {.seed = 0, .x = x, .y = y, .index = 5};
          return std::pair(draw(kind, key, 1, a), draw(kind, key, 1, b));
        });
      }
}

TEST_CASE("neighbouring pixels, vertices and seeds are independent of each other") {
  struct Change {
    std::uint64_t seed;
    std::uint32_t x, y, vertex;
  };
  const Change changes[] = {{0, 1, 0, 0},          {0, 0, 1, 0},          {0, 0, 0, 1}, {1, 0, 0, 0},
                            {1ull << 32, 0, 0, 0}, {1ull << 63, 0, 0, 0}, {0, 2, 0, 0}, {0, 256, 0, 0},
                            {0, 0, 0x8000, 0},     {0, 0, 0, 1u << 31},   {1, 1, 1, 1}};
  const int members[] = {0, 3, 8, 15};
  const int tests = 2 * int(std::size(changes)) * int(std::size(members));
  for (const SamplerKind kind : kinds)
    for (const Change& change : changes)
      for (const int d : members) {
        CAPTURE(sampler_name(kind), change.seed, change.x, change.y, change.vertex, d);
        check_pairs(tests, [&](auto x, auto y) {
          const SampleKey a = {.seed = 4, .x = x, .y = y, .index = 2},
                          b = {.seed = 4 + change.seed, .x = x + change.x, .y = y + change.y, .index = 2};
          return std::pair(draw(kind, a, 1, d), draw(kind, b, 1 + change.vertex, d));
        });
      }
}

TEST_CASE("each dimension of sobol is scrambled on its own") {
  // Samples 2k and 2k + 1 lie in different halves of every dimension. Where in its half each one lies has
  // nothing to do with the other, nor with the other dimension: four independent numbers. A scramble that two
  // dimensions share gives them digits that stay equal where the sequence has equal ones, for both samples.
  const auto cell = [](float u) { return float(int(8 * u) % 4); };  // Digits 2 and 3 in base 2.
  for (int first = 0; first < dimensions; first += 4)
    for (int a = first; a < first + 4; ++a)
      for (int b = a + 1; b < first + 4; ++b) {
        CAPTURE(a, b);
        check_pairs(4 * 6, [&](auto x, auto y) {
          const auto cells = [&](std::uint32_t index) {
            const SampleKey key = {.seed = 6, .x = x, .y = y, .index = index};
            return (cell(draw(SamplerKind::sobol, key, 1, a)) * 4 +
                    cell(draw(SamplerKind::sobol, key, 1, b))) /
                   16;
          };
          return std::pair(cells(4), cells(5));
        });
      }
}

TEST_CASE("samples of the independent kind are independent of each other") {
  const std::uint32_t distances[] = {1, 2, 64, 1u << 31};
  for (const std::uint32_t distance : distances)
    check_pairs(int(std::size(distances)), [&](auto x, auto y) {
      const SampleKey a = {.seed = 4, .x = 9, .y = 9, .index = y << 8 | x};
      SampleKey b = a;
      b.index += distance;
      return std::pair(draw(SamplerKind::independent, a, 1, 0), draw(SamplerKind::independent, b, 1, 0));
    });
}

TEST_CASE("sub-samples continue the sequence of the samples") {
  const SampleKey key = {.seed = 2, .x = 5, .y = 6, .index = 11};
  constexpr DrawPlace place{3, 1, 2};
  for (const SamplerKind kind : kinds)
    for (std::uint32_t part = 0; part < 5; ++part) {
      SampleKey other = key;
      other.index = key.index * 5 + part;
      CHECK(draw_pair(kind, PathKey(key), place, {.part = part, .parts = 5}) ==
            draw_pair(kind, PathKey(other), place));
    }
}

TEST_CASE("streams of sub-samples are independent of each other and of the samples") {
  for (const SamplerKind kind : kinds)
    for (const std::uint32_t stream : {1u, 2u, 0xffffffffu}) {
      CAPTURE(sampler_name(kind), stream);
      check_pairs(6, [&](auto x, auto y) {
        const VertexSampler sampler(kind, PathKey({.seed = 0, .x = x, .y = y, .index = 5}), 1);
        const Vec2 first = sampler.draw_2d(Purpose::light_point, {1, 4, stream});
        const Vec2 second = sampler.draw_2d(Purpose::light_point, {1, 4, stream - 1});
        return std::pair(first.x, second.x);
      });
    }
}

TEST_CASE("sub-samples do not repeat beyond 2^32") {
  // 2^16 parts: sample 0x10003 is 2^32 draws after sample 3.
  for (const SamplerKind kind : kinds) {
    const auto draw_of = [&](std::uint32_t index) {
      return draw_pair(kind, PathKey({.index = index}), {1, 0, 2}, {.part = 7, .parts = 1 << 16});
    };
    CHECK_FALSE(draw_of(3) == draw_of(0x10003));
  }
}

TEST_CASE("the numbers of a seed never change") {
  struct Frozen {
    SampleKey key;
    std::uint32_t vertex;
    int dimension;
    float sobol, independent;
  };
  const Frozen table[] = {
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x0u, 8, 0x1.9a8dfcp-1f, 0x1.71a542p-1f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x0u, 9, 0x1.f5a8bep-1f, 0x1.3da95ep-1f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x1u}, 0x0u, 8, 0x1.58004cp-2f, 0x1.4c3094p-2f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x1u, 0, 0x1.8f6f1ep-1f, 0x1.b2ae98p-2f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x1u, 1, 0x1.6a4b3p-3f, 0x1.f395fcp-2f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x1u, 2, 0x1.698e28p-1f, 0x1.716792p-1f},
      {{.seed = 0x0u, .x = 0, .y = 0, .index = 0x0u}, 0x1u, 3, 0x1.cb72p-5f, 0x1.996998p-3f},
      {{.seed = 0x1u, .x = 0, .y = 0, .index = 0x0u}, 0x1u, 4, 0x1.996c24p-1f, 0x1.10f428p-3f},
      {{.seed = 0x0u, .x = 1, .y = 0, .index = 0x0u}, 0x1u, 5, 0x1.e532c2p-1f, 0x1.2c81bcp-2f},
      {{.seed = 0x0u, .x = 0, .y = 1, .index = 0x0u}, 0x1u, 6, 0x1.d7b654p-1f, 0x1.d64f6cp-2f},
      {{.seed = 0x123456789abcdefu, .x = 1919, .y = 1079, .index = 0xfffu},
       0x7u,
       13,
       0x1.50b478p-2f,
       0x1.a14fe8p-2f},
      {{.seed = 0xffffffffffffffffu, .x = 65535, .y = 65535, .index = 0xffffffffu},
       0xffffffffu,
       15,
       0x1.5e348p-6f,
       0x1.e3d02ep-1f}};
  for (const Frozen& row : table) {
    CAPTURE(row.key.seed, row.key.x, row.key.y, row.key.index, row.vertex, row.dimension);
    CHECK(draw(SamplerKind::sobol, row.key, row.vertex, row.dimension) == row.sobol);
    CHECK(draw(SamplerKind::independent, row.key, row.vertex, row.dimension) == row.independent);
  }
}

TEST_CASE("samplers are known by their names") {
  for (const SamplerKind kind : kinds) CHECK(parse_sampler(sampler_name(kind)) == kind);
  CHECK(sampler_name(SamplerKind::sobol) == "sobol");
  CHECK_THROWS_WITH(parse_sampler("halton"), "unknown sampler \"halton\"; valid are: sobol, independent");
  CHECK_THROWS_AS(parse_sampler(""), Error);
}

}  // namespace twinray
