// SPDX-License-Identifier: Apache-2.0
// Films as columns of numbers, and back.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/film.h"
#include "tests/support/film_bytes.h"
#include "tests/support/random.h"

namespace twinray::test {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr PixelRect window{-2, 1, 9, 12};

FilmContents everything() { return {all_layers(), {3, 2}}; }

/// Sums of one word and of more, pixels with no and with many ids, samples that are not accepted.
FilmSample sample_of(const Film& film, int x, int y, std::uint32_t index) {
  Random random(std::uint64_t(index) * 1000003 + std::uint64_t((y + 50) * 500 + x + 50));
  const auto number = [&] { return random.uniform(-1, 1) * (random.below(4) == 0 ? 9e8f : 3.0f); };
  const auto color = [&]() -> Rgb { return {number(), number(), number()}; };
  FilmSample sample{color(), {}, {color(), color(), color()}, {color(), color()}};
  if (random.below(40) == 0) sample.color.g = not_a_number;
  if (random.below(5) == 0) sample.paths[1] = {};
  for (const Layer layer : film.layers()) {
    sample.layers.push_back(color());
    if (layer_info(layer).gathering == Gathering::coverage)
      sample.layers.back() = record_id(std::uint32_t(random.below(9)));
    if (random.below(5) == 0 && layer_info(layer).gathering == Gathering::first)
      sample.layers.back().r = not_a_number;
  }
  return sample;
}

template <typename Take>
void for_each_pixel(const Film& film, const Take& take) {
  const PixelRect& pixels = film.window();
  for (int y = pixels.y0; y < pixels.y1; ++y)
    for (int x = pixels.x0; x < pixels.x1; ++x) take(x, y);
}

void add_samples(Film& film, std::uint32_t begin, std::uint32_t end) {
  for_each_pixel(film, [&](int x, int y) {
    for (std::uint32_t index = begin; index < end; ++index)
      add_sample(film, x, y, index, sample_of(film, x, y, index));
  });
}

Film film_of(std::uint32_t begin, std::uint32_t end) {
  Film film(8, 13, window, everything());
  add_samples(film, begin, end);
  return film;
}

}  // namespace

TEST_CASE("a film comes back from the columns of its bands with every layer and sum") {
  const Film film = film_of(0, 12);
  Film again(8, 13, window, everything());
  for (int y0 = window.y0; y0 < window.y1; y0 += 4) {
    const int y1 = std::min(y0 + 4, window.y1);
    ColumnWriter writer;
    film.save(y0, y1, writer);
    ColumnReader reader(writer.bytes());
    Film band(8, 13, {window.x0, y0, window.x1, y1}, everything());
    add_samples(band, 50, 51);  // What was there before is not there afterwards.
    band.load(reader);
    CHECK(reader.is_at_end());
    again.merge(band);
  }
  CHECK(bytes_of(again) == bytes_of(film));
  CHECK(again.first_rejected().index == film.first_rejected().index);
  const std::size_t matte = std::size_t(Layer::object_matte);
  REQUIRE(film.layers()[matte] == Layer::object_matte);
  bool has_many = false;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      CHECK(again.pixel(x, y) == film.pixel(x, y));
      CHECK(again.coverage(matte, x, y) == film.coverage(matte, x, y));
      has_many = has_many || film.coverage(matte, x, y).size() > CoveragePixels::together;
      for (const Division division : divisions) {
        const std::vector<Rgb> parts = parts_at(again, division, x, y), were = parts_at(film, division, x, y);
        CHECK(std::equal(parts.begin(), parts.end(), were.begin()));
      }
    }
  CHECK(has_many);
}

TEST_CASE("the columns of a film do not depend on the order of its samples") {
  Film backwards(8, 13, window, everything());
  for (std::uint32_t index = 12; index-- > 0;) add_samples(backwards, index, index + 1);
  CHECK(bytes_of(backwards) == bytes_of(film_of(0, 12)));
  CHECK(bytes_of(backwards) != bytes_of(film_of(0, 11)));
}

TEST_CASE("samples of a pixel that are added together are those added one after the other") {
  Film together(8, 13, window, everything());
  Records records(together.contents(), 20);
  const RecordSpans spans = records.spans(20);
  for_each_pixel(together, [&](int x, int y) {
    for (std::uint32_t i = 0; i < 12; ++i)
      write_record(together, sample_of(together, x, y, i), spans, 5 + std::size_t(i));
    together.add(x, y, 7, spans, 5 + 7, 5);
    together.add(x, y, 0, spans, 5, 7);
    together.add(x, y, 12, spans, 0, 0);
  });
  const Film expected = film_of(0, 12);
  REQUIRE(expected.rejected_count() > 20);
  CHECK(bytes_of(together) == bytes_of(expected));
}

TEST_CASE("what is no film's columns is an error") {
  const std::vector<std::byte> bytes = bytes_of(film_of(0, 6));
  Film film(8, 13, window, everything());
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    ColumnReader cut(std::span<const std::byte>(bytes.data(), size));
    CHECK_THROWS_AS(film.load(cut), Error);
  }
  // Of a pixel the number of samples is the tenth word of 16.
  std::vector<std::byte> wrong = bytes;
  const std::size_t pixels = std::size_t(window.width()) * std::size_t(window.height());
  wrong[(9 * 4 + 3) * pixels + 7] = std::byte{0x7f};
  ColumnReader reader(wrong);
  CHECK_THROWS_WITH(film.load(reader), "a pixel has more than 4194304 samples");
}

}  // namespace twinray::test
