// SPDX-License-Identifier: Apache-2.0
#include "core/layer_pixels.h"

#include <limits>
#include <set>
#include <string>

#include "core/layer.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace twinray {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE(
    "layers have names of their own, one to three channels or ranks, and no channel of another's name") {
  std::set<std::string> names, channels;
  for (const Layer layer : all_layers()) {
    CHECK(names.insert(layer_info(layer).name).second);
    const bool has_ranks = layer_info(layer).gathering == Gathering::coverage;
    CHECK(channel_count(layer) >= 1);
    CHECK(channel_count(layer) <= (has_ranks ? 2 * coverage_ranks : 3));
    for (const std::string& channel : layer_info(layer).channels) CHECK(channels.insert(channel).second);
  }
  CHECK(names.size() == layer_count);
}

TEST_CASE("sums hold every unit, however large they become") {
  ExactSums sums(3);
  constexpr int count = 5000;  // 5000 times 10^9 overflows 63 bits of 2^-43 about 5 million times.
  const auto add = [&](float first, float second) {
    for (int i = 0; i < count; ++i) {
      const Rgb values{first, second, 0};
      sums.add(0, 2, {&values, 1});
    }
  };
  add(1e9f, -1e9f);
  const std::vector<Rgb> least(count, Rgb{0x1p-43f, 0, 0});
  sums.add(2, 1, least);
  CHECK(sums.units(0) == count * fixed_units(1e9));
  CHECK(sums.units(1) == -count * fixed_units(1e9));
  CHECK(sums.units(2) == count);
  CHECK(sums.mean(0, count) == 1e9f);
  CHECK(sums.mean(1, count) == -1e9f);
  CHECK(sums.mean(2, count) == 0x1p-43f);
  CHECK(sums.mean(0, 0) == 0);
  add(-1e9f, 1e9f);
  CHECK(sums.units(0) == 0);
  CHECK(sums.units(1) == 0);
}

TEST_CASE("samples that are added together give what they give one by one, however large they are") {
  test::Random random(5);
  for (const float largest : {0x1p-30f, 1.0f, 0x1p15f, 0x1p19f, 0x1p21f, 1e9f}) {
    std::vector<Rgb> colors;
    for (int i = 0; i < 64; ++i)
      colors.push_back({random.uniform(-largest, largest), random.uniform(0, largest), -largest});
    colors[7].r = nan;
    for (const std::size_t stride : {1u, 3u}) {
      CAPTURE(largest, stride);
      ExactSums together(3), one_by_one(3);
      together.add(0, 3, colors, stride);
      for (std::size_t i = 0; i < colors.size(); i += stride) one_by_one.add(0, 3, {&colors[i], 1});
      for (std::size_t channel = 0; channel < 3; ++channel)
        CHECK(together.units(channel) == one_by_one.units(channel));
      if (stride == 1) CHECK(together.units(2) == -64 * fixed_units(largest));
    }
  }
}

TEST_CASE("the sums of two films of a layer are those of all samples") {
  test::Random random(3);
  MeanPixels all(1, 1), even(1, 1), odd(1, 1);
  for (int i = 0; i < 3000; ++i) {
    const Rgb value{random.uniform(-1, 1) * (i % 7 == 0 ? 1e9f : 1.0f), 0, 0};
    all.add(0, {&value, 1});
    (i % 2 == 0 ? even : odd).add(0, {&value, 1});
  }
  odd.merge(0, even, 0);
  CHECK(odd.mean(0, 3000) == all.mean(0, 3000));
}

TEST_CASE("what is no number counts as 0 in a layer, and what is too large as the largest") {
  MeanPixels pixels(1, 3);
  const Rgb value{nan, 1e30f, -1e30f};
  pixels.add(0, {&value, 1});
  CHECK(pixels.mean(0, 1) == Rgb{0, max_radiance, -max_radiance});
}

TEST_CASE("of points the sample with the least index that has a value counts, in any order") {
  FirstPixels forward(3, 2), backward(3, 2);
  const Rgb none{nan, 0, 0};
  const Rgb values[] = {none, {1, 2, 0}, {3, 4, 0}};
  for (std::uint32_t i = 0; i < 3; ++i) forward.add(1, i, values[i]);
  for (std::uint32_t i = 3; i-- > 0;) backward.add(1, i, values[i]);
  for (const FirstPixels* const pixels : {&forward, &backward}) {
    CHECK(pixels->has(1));
    CHECK(pixels->value(1) == Rgb{1, 2, 0});
    CHECK_FALSE(pixels->has(0));
  }
  FirstPixels later(1, 2);
  later.add(0, 2, values[2]);
  FirstPixels merged = later;
  merged.merge(0, forward, 1);
  CHECK(merged.value(0) == Rgb{1, 2, 0});
  merged.merge(0, later, 0);
  merged.merge(0, forward, 0);  // It has none.
  CHECK(merged.value(0) == Rgb{1, 2, 0});
}

}  // namespace twinray
