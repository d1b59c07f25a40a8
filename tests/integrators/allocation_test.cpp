// SPDX-License-Identifier: Apache-2.0
#include "integrators/allocation.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "core/error.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/random.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

constexpr std::uint32_t pilot = SampleAllocation::pilot;

/// A pilot of one colour, but where it is changed.
struct Pilot {
  PixelRect window;
  std::vector<Rgb> half, whole;

  explicit Pilot(const PixelRect& rect)
      : window(rect),
        half(std::size_t(rect.width()) * std::size_t(rect.height()), {0.5f, 0.5f, 0.5f}),
        whole(half) {}
  std::size_t index(int x, int y) const {
    return std::size_t(y - window.y0) * std::size_t(window.width()) + std::size_t(x - window.x0);
  }
  /// Makes a pixel's halves differ.
  void set_noise(int x, int y, float difference) {
    half[index(x, y)] = whole[index(x, y)] + Rgb{difference, difference, difference};
  }
  SampleAllocation allocation() const { return {window, half, whole}; }
};

template <typename F>
void for_each_pixel(const PixelRect& window, const F& f) {
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) f(x, y);
}

double mean_samples(const SampleAllocation& allocation, const PixelRect& window, std::uint32_t n) {
  double sum = 0;
  for_each_pixel(window, [&](int x, int y) { sum += allocation.samples_of(x, y, n); });
  return sum / (double(window.width()) * window.height());
}

/// A pilot whose noise grows from left to right, and whose brightness from pixel to pixel.
Pilot uneven(const PixelRect& window) {
  Pilot made(window);
  for_each_pixel(window, [&](int x, int y) {
    const float level = 0.2f + 0.1f * float((x + 3 * y - window.x0) % 7);
    made.whole[made.index(x, y)] = {level, level, level};
    made.set_noise(x, y, 0.01f * float(x - window.x0 + 1));
  });
  return made;
}

RenderOptions by_error(std::uint32_t samples, int threads) {
  return {.width = 40,
          .height = 30,
          .samples = samples,
          .allocation = Allocation::error,
          .seed = 5,
          .threads = threads};
}

/// Calm, but for noise in the columns from x = 30 on; its mean is 1/2.
class NoisyColumns final : public PlainIntegrator {
  Rgb radiance_of(const CameraSample& sample, SamplerKind kind, Tracer&) const override {
    const float u = VertexSampler(kind, PathKey(sample.key), 0).draw_2d(Purpose::light_point).x;
    const float value = sample.key.x < 30 ? 0.49f + 0.02f * u : u;
    return {value, value, value};
  }
};

double squared_error(const Film& film) {
  double sum = 0;
  for_each_pixel(film.window(), [&](int x, int y) {
    const double difference = film.pixel(x, y).luminance_mean() - 0.5;
    sum += difference * difference;
  });
  return sum;
}

}  // namespace

TEST_CASE("samples are even up to the pilot, more where the pilot has noise, and as many on average") {
  const PixelRect window{-3, 5, 37, 29};
  const SampleAllocation allocation = uneven(window).allocation();
  for (const std::uint32_t n : {1u, 15u, pilot})
    for_each_pixel(window, [&](int x, int y) { CHECK(allocation.samples_of(x, y, n) == n); });
  for (const std::uint32_t n : {17u, 64u, 1000u}) {
    CAPTURE(n);
    CHECK(std::abs(mean_samples(allocation, window, n) - n) < 0.02 * (n - pilot) + 0.5);
    CHECK(allocation.samples_of(36, 10, n) >= allocation.samples_of(-3, 10, n));
  }
  CHECK(allocation.samples_of(36, 10, 1000) > 5 * allocation.samples_of(-3, 10, 1000));
  CHECK(allocation.samples_of(-3, 10, 1000) >= pilot + (1000 - pilot) / 8);
}

TEST_CASE("no pixel has fewer samples where the picture has more, nor more than a film may count") {
  const PixelRect window{0, 0, 9, 7};
  const SampleAllocation allocation = uneven(window).allocation();
  for_each_pixel(window, [&](int x, int y) {
    std::uint32_t before = 0;
    for (std::uint32_t n = 0; n < 300; ++n) {
      const std::uint32_t now = allocation.samples_of(x, y, n);
      CHECK(now >= before);
      before = now;
    }
    CHECK(allocation.samples_of(x, y, Film::max_samples) <= Film::max_samples);
  });
}

TEST_CASE("without any noise, and without neighbours, samples are even") {
  const PixelRect window{0, 0, 12, 8};
  const SampleAllocation calm = Pilot(window).allocation();
  for_each_pixel(window, [&](int x, int y) { CHECK(calm.samples_of(x, y, 100) == 100); });
  Pilot black(window);
  black.half.assign(black.half.size(), {});
  black.whole = black.half;
  CHECK(black.allocation().samples_of(3, 3, 100) == 100);
  Pilot lone({4, 4, 5, 5});
  lone.set_noise(4, 4, 1);
  CHECK(lone.allocation().samples_of(4, 4, 100) == 100);
}

TEST_CASE("one noisy pixel does not take the samples of all others") {
  const PixelRect window{0, 0, 200, 100};
  Pilot pilot_of_one(window);
  pilot_of_one.set_noise(100, 50, 1000);
  const SampleAllocation allocation = pilot_of_one.allocation();
  CHECK(allocation.samples_of(101, 50, 1016) <= pilot + 16 * 1000);
  CHECK(allocation.samples_of(101, 50, 1016) > 10000);
  CHECK(allocation.samples_of(10, 11, 1016) == pilot + 125);
  // The pixels of its own colour have seen nothing.
  CHECK(allocation.samples_of(100, 50, 1016) == 1016);
}

TEST_CASE("noise gives samples to pixels at most three columns and rows away, on all sides") {
  Pilot noisy({0, 0, 60, 40});
  noisy.set_noise(30, 20, 1);
  const SampleAllocation allocation = noisy.allocation();
  for_each_pixel(noisy.window, [&](int x, int y) {
    CAPTURE(x, y);
    const int columns = std::abs(x - 30), rows = std::abs(y - 20);
    if ((columns + rows) % 2 == 0) return;  // Of its own colour.
    CHECK((allocation.samples_of(x, y, 1016) > 1016) == (columns <= 3 && rows <= 3));
  });
}

TEST_CASE("the samples of a pixel do not depend on the pilot of any pixel of its colour") {
  const PixelRect window{2, 3, 22, 18};
  const SampleAllocation before = uneven(window).allocation();
  for (const int color : {0, 1}) {
    Pilot changed = uneven(window);
    Random random(7);
    for_each_pixel(window, [&](int x, int y) {
      if (((x + y) & 1) != color) return;
      changed.whole[changed.index(x, y)] = {random.unit(), random.unit(), random.unit()};
      changed.half[changed.index(x, y)] = {random.unit(), random.unit(), random.unit()};
    });
    const SampleAllocation after = changed.allocation();
    int differ = 0;
    for_each_pixel(window, [&](int x, int y) {
      const bool is_same = after.samples_of(x, y, 1000) == before.samples_of(x, y, 1000);
      if (((x + y) & 1) == color)
        CHECK(is_same);
      else
        differ += !is_same;
    });
    CHECK(differ > 100);
  }
}

TEST_CASE("means are unbiased where rare samples are bright") {
  constexpr float dark = 0.1f, bright = 5, chance = 0.03f;
  constexpr int trials = 1500;
  const PixelRect window{0, 0, 8, 8};
  Random random(3);
  const auto draw = [&] { return random.unit() < chance ? bright : dark; };
  double sum = 0, squares = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Pilot made(window);
    std::vector<double> sums(made.whole.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const auto mean_so_far = [&](std::uint32_t n) {
        const float mean = float(sums[i] / n);
        return Rgb{mean, mean, mean};
      };
      for (std::uint32_t k = 0; k < pilot; ++k) {
        if (k == pilot / 2) made.half[i] = mean_so_far(k);
        sums[i] += draw();
      }
      made.whole[i] = mean_so_far(pilot);
    }
    const SampleAllocation allocation = made.allocation();
    double mean = 0;
    for_each_pixel(window, [&](int x, int y) {
      double& pixel = sums[made.index(x, y)];
      const std::uint32_t samples = allocation.samples_of(x, y, 48);
      for (std::uint32_t k = pilot; k < samples; ++k) pixel += draw();
      mean += pixel / samples / 64;
    });
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / trials;
  const double error = std::sqrt((squares / trials - mean * mean) / (trials - 1));
  check_mean({mean, error}, double(chance) * bright + double(1 - chance) * dark, 0.02);
}

TEST_CASE("a picture whose samples are spread by error is the same on every engine") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  const RenderResult spread = render_with(scene, path, by_error(64, 1));
  for (const int threads : {2, 5})
    CHECK(same_bits(render_with(scene, path, by_error(64, threads), Backend::brute_force).film, spread.film));
}

TEST_CASE("a picture with noise in a few places has less of it by as many samples") {
  RenderOptions even = by_error(64, 1);
  even.allocation = Allocation::even;
  even.sampler = SamplerKind::independent;
  RenderOptions spread = even;
  spread.allocation = Allocation::error;
  const Scene scene = small_room();
  const Film evenly = render_with(scene, NoisyColumns(), even).film;
  const Film by_noise = render_with(scene, NoisyColumns(), spread).film;
  CHECK(std::abs(double(sample_count(by_noise)) / double(sample_count(evenly)) - 1) < 0.02);
  CHECK(squared_error(by_noise) < 0.6 * squared_error(evenly));
}

TEST_CASE("spread samples have the bits of an undisturbed render, wherever that goes on") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult expected = render_with(scene, path, by_error(50, 2));
  std::atomic<int> asked = 0;
  std::vector<RenderState> states;
  RenderOptions resting = by_error(50, 3);
  resting.is_pause_due = [&] { return asked++ % 5 == 4; };
  resting.paused = [&](const RenderState& state) { states.push_back(state); };
  CHECK(same_bits(render_with(scene, path, resting).film, expected.film));
  REQUIRE(states.size() > 5);
  const auto resumed = [&](const RenderState& state, RenderOptions options) {
    options.restore = [&](RenderState& empty) { empty = state; };
    return render_with(scene, path, options);
  };
  for (const RenderState& state : states) {
    const RenderResult result = resumed(state, by_error(50, 2));
    CHECK(result.is_complete);
    CHECK(same_bits(result.film, expected.film));
    CHECK(result.rays == expected.rays);
  }
  CHECK(same_bits(resumed(expected, by_error(90, 2)).film, render_with(scene, path, by_error(90, 1)).film));
  CHECK_THROWS_AS(resumed(expected, by_error(40, 2)), Error);
}

TEST_CASE("a render that has no more than the pilot is even, and goes on") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  for (const std::uint32_t samples : {8u, 12u, 16u}) {
    CAPTURE(samples);
    RenderOptions even = by_error(samples, 2);
    even.allocation = Allocation::even;
    const RenderResult expected = render_with(scene, path, even);
    RenderResult begun = render_with(scene, path, by_error(8, 1));
    RenderOptions more = by_error(samples, 2);
    more.restore = [&](RenderState& empty) { empty = begun; };
    CHECK(same_bits(render_with(scene, path, more).film, expected.film));
  }
}

TEST_CASE("a render that is stopped while it makes its pilot again is not complete, and keeps what it has") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult done = render_with(scene, path, by_error(50, 1));
  RenderOptions stopped = by_error(90, 1);
  stopped.restore = [&](RenderState& empty) { empty = done; };
  stopped.is_stopped = [] { return true; };
  const RenderResult result = render_with(scene, path, stopped);
  CHECK_FALSE(result.is_complete);
  CHECK(same_bits(result.film, done.film));
}

TEST_CASE("what cannot be spread by error is refused") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const auto refused = [&](const std::function<void(RenderOptions&)>& change, const std::string& message) {
    RenderOptions wrong = by_error(32, 1);
    change(wrong);
    CHECK_THROWS_WITH(render_with(scene, path, wrong), message);
  };
  const std::string no_parts =
      "samples are spread by the error of the whole picture, which a part does not have";
  refused([](RenderOptions& o) { o.range = {0, 4}; }, no_parts);
  refused([](RenderOptions& o) { o.tiles = {0, 4}; }, no_parts);
  refused([](RenderOptions& o) { o.adaptive.emplace(); },
          "samples are spread by error, or adaptive sampling takes fewer; not both");
}

}  // namespace twinray::test
