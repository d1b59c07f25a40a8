// SPDX-License-Identifier: Apache-2.0
// A picture in tiles, each with the version in which it last changed.
#include "cli/live/live_image.h"

#include <array>
#include <cstring>
#include <thread>

#include "integrators/render.h"
#include "tests/support/catch.h"

namespace twinray::test {
namespace {

using namespace std::chrono_literals;
using Clock = LiveImage::Clock;

/// 3 x 2 tiles, not all of them whole.
constexpr PixelRect window{5, 7, 5 + 40, 7 + 20};

std::vector<PixelRect> tiles() { return spiral_tiles(window, tile_size); }

std::vector<float> values_of(const PixelRect& tile, float value, std::size_t channels = 2) {
  return std::vector<float>(std::size_t(tile.width()) * std::size_t(tile.height()) * channels, value);
}

/// A tile as it goes out.
struct Sent {
  std::array<std::uint32_t, 4> place;  ///< x, y, width, height
  std::vector<float> values;
};

std::vector<Sent> sent(const LiveBytes& bytes, std::size_t channels = 2) {
  std::vector<Sent> all;
  for (std::size_t at = 0; at < bytes.bytes.size();) {
    Sent& one = all.emplace_back();
    std::memcpy(one.place.data(), bytes.bytes.data() + at, 16);
    one.values.resize(std::size_t(one.place[2]) * one.place[3] * channels);
    std::memcpy(one.values.data(), bytes.bytes.data() + at + 16, one.values.size() * sizeof(float));
    at += 16 + one.values.size() * sizeof(float);
  }
  CHECK(all.size() == bytes.tiles);
  return all;
}

}  // namespace

TEST_CASE("of a picture in tiles those are sent that changed since") {
  LiveImage image(window, 2);
  CHECK(image.version() == 0);
  CHECK(image.changed_since(0).tiles == 0);
  const Clock::time_point now = Clock::now();
  for (const PixelRect& tile : tiles()) image.put(tile, values_of(tile, 1), now);
  CHECK(image.version() == 6);
  CHECK(sent(image.changed_since(0)).size() == 6);
  CHECK(image.changed_since(6).tiles == 0);

  const PixelRect last{5 + 32, 7 + 16, 5 + 40, 7 + 20};
  std::vector<float> values = values_of(last, 1);
  values[2 * (8 * 1 + 3) + 1] = 7;  // the second channel of the fourth pixel of the second row
  image.put(last, values, now);
  const LiveBytes changed = image.changed_since(6);
  CHECK(changed.version == 7);
  const std::vector<Sent> one = sent(changed);
  REQUIRE(one.size() == 1);
  CHECK(one[0].place == std::array<std::uint32_t, 4>{32, 16, 8, 4});
  CHECK(one[0].values == values);

  const LiveBytes all = image.all();
  CHECK(all.version == 7);
  std::vector<float> pixels(40 * 20 * 2);
  REQUIRE(all.bytes.size() == pixels.size() * sizeof(float));
  std::memcpy(pixels.data(), all.bytes.data(), all.bytes.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    CHECK(pixels[i] == (i == 2 * (40 * 17 + 35) + 1 ? 7.0f : 1.0f));
}

TEST_CASE("a tile with the values that it had has the version that it had") {
  LiveImage image(window, 2);
  for (const PixelRect& tile : tiles()) {
    CHECK(image.version() == 0);  // There is no picture before all tiles are there.
    image.put(tile, values_of(tile, 0), Clock::now());
  }
  CHECK(image.version() == 6);  // They were not there before, though all is 0.
  const PixelRect tile = tiles().front();
  image.put(tile, values_of(tile, 0), Clock::now());
  CHECK(image.version() == 6);
  image.put(tile, values_of(tile, -0.0f), Clock::now());
  CHECK(image.version() == 7);
}

TEST_CASE("a tile is due a fifth of a second after it was put, and old in the meantime") {
  LiveImage image(window, 2);
  const PixelRect tile = tiles()[1], other = tiles()[2];
  const Clock::time_point now = Clock::now();
  CHECK(image.is_due(tile, now));
  CHECK(image.is_old(tile));
  image.put(tile, values_of(tile, 1), now);
  CHECK_FALSE(image.is_old(tile));
  CHECK_FALSE(image.is_due(tile, now + 199ms));
  CHECK(image.is_old(tile));
  CHECK(image.is_due(tile, now + 200ms));
  CHECK(image.is_due(other, now));
  image.put(tile, values_of(tile, 1), now);
  image.age();
  CHECK(image.is_old(tile));
  CHECK(image.is_due(tile, now + 1s));
}

TEST_CASE("whoever takes what changed again and again ends with the picture") {
  LiveImage image(window, 2);
  std::jthread writer([&] {
    for (int value = 1; value <= 500; ++value)
      for (const PixelRect& tile : tiles()) image.put(tile, values_of(tile, float(value)), Clock::now());
  });
  std::vector<float> seen(6, 0);
  std::uint64_t version = 0;
  while (version < 500 * 6) {
    const LiveBytes changed = image.changed_since(version);
    for (const Sent& one : sent(changed)) {
      // No tile is half one, half another.
      CHECK(one.values == std::vector<float>(one.values.size(), one.values.front()));
      seen[one.place[1] / 16 * 3 + one.place[0] / 16] = one.values.front();
    }
    version = changed.version;
  }
  CHECK(seen == std::vector<float>(6, 500));
}

}  // namespace twinray::test
