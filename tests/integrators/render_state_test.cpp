// SPDX-License-Identifier: Apache-2.0
// Renders that rest, go on elsewhere, and are shared among several.
#include <atomic>
#include <vector>

#include "core/error.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/estimate.h"
#include "tests/support/film_bytes.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

RenderOptions kept_options(std::uint32_t samples, int threads) {
  return {.width = 40, .height = 30, .samples = samples, .seed = 5, .threads = threads};
}

/// What a render keeps of everything.
RenderOptions rich(RenderOptions plain) {
  plain.layers = {Layer::albedo, Layer::position, Layer::ids, Layer::object_matte};
  plain.light_paths = true;
  plain.half_layers = std::vector{Layer::normal};
  return plain;
}

bool is_same(const RenderState& a, const RenderState& b) {
  if (a.halves.has_value() != b.halves.has_value()) return false;
  if (a.halves && (bytes_of(a.halves->first) != bytes_of(b.halves->first) ||
                   bytes_of(a.halves->second) != bytes_of(b.halves->second)))
    return false;
  return bytes_of(a.film) == bytes_of(b.film) && a.rays == b.rays && a.samples == b.samples &&
         a.error == b.error;
}

/// The states in which a render rests, each time that so many tiles were asked about.
std::vector<RenderState> states_of(const Scene& scene, const Integrator& integrator,
                                   RenderOptions kept_options, int every) {
  std::vector<RenderState> states;
  std::atomic<int> asked = 0;
  kept_options.is_pause_due = [&, every] { return asked++ % every == every - 1; };
  kept_options.paused = [&](const RenderState& state) { states.push_back(state); };
  render_with(scene, integrator, kept_options);
  return states;
}

RenderOptions resuming(const RenderState& state, RenderOptions kept_options) {
  kept_options.restore = [&state](RenderState& empty) { empty = state; };
  return kept_options;
}

}  // namespace

TEST_CASE("a render that rests has the bits of one that does not") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  const RenderOptions plain = rich(kept_options(9, 3));
  const RenderResult expected = render_with(scene, path, plain);
  RenderOptions resting = plain;
  int rests = 0;
  std::atomic<int> asked = 0;
  resting.is_pause_due = [&] { return asked++ % 5 == 4; };
  resting.paused = [&](const RenderState&) { ++rests; };
  const RenderResult result = render_with(scene, path, resting);
  CHECK(result.is_complete);
  CHECK(rests > 3);
  CHECK(is_same(result, expected));
}

TEST_CASE("a render goes on from any state to the bits and the rays of an undisturbed one") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  const RenderOptions plain = rich(kept_options(13, 2));
  const RenderResult expected = render_with(scene, path, plain);
  const std::vector<RenderState> states = states_of(scene, path, plain, 4);
  REQUIRE(states.size() >= 5);
  int threads = 0;
  for (const RenderState& state : states) {
    CHECK_FALSE(bytes_of(state.film) == bytes_of(expected.film));
    RenderOptions other = resuming(state, plain);
    other.threads = 1 + threads++ % 3;
    const Backend backend = threads % 2 == 0 ? Backend::bvh : Backend::brute_force;
    const RenderResult result = render_with(scene, path, other, backend);
    CHECK(result.is_complete);
    CHECK(is_same(result, expected));
  }
}

TEST_CASE("a render that was stopped amid a tile goes on without a gap") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult expected = render_with(scene, path, kept_options(40, 1));
  for (const int most : {0, 1, 300, 1199, 1300, 2500, 4000, 6111}) {
    CAPTURE(most);
    RenderOptions stopped = kept_options(40, 2);
    std::atomic<int> asked = 0;
    stopped.is_stopped = [&asked, most] { return ++asked > most; };
    const RenderResult partial = render_with(scene, path, stopped);
    REQUIRE_FALSE(partial.is_complete);
    const RenderResult result = render_with(scene, path, resuming(partial, kept_options(40, 2)));
    CHECK(result.is_complete);
    CHECK(is_same(result, expected));
  }
}

TEST_CASE("adaptive sampling decides alike in a render that goes on") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions adaptive = kept_options(70, 2);
  adaptive.adaptive = AdaptiveSampling{8, 0.3};
  const RenderResult expected = render_with(scene, path, adaptive);
  for (const RenderState& state : states_of(scene, path, adaptive, 6))
    CHECK(is_same(render_with(scene, path, resuming(state, adaptive)), expected));
}

TEST_CASE("a render that is done needs nothing more, and takes more samples") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult done = render_with(scene, path, kept_options(20, 1));
  const RenderResult again = render_with(scene, path, resuming(done, kept_options(20, 2)));
  CHECK(again.is_complete);
  CHECK(is_same(again, done));
  const RenderResult more = render_with(scene, path, resuming(done, kept_options(50, 2)));
  CHECK(is_same(more, render_with(scene, path, kept_options(50, 1))));
  CHECK_THROWS_WITH(render_with(scene, path, resuming(done, kept_options(19, 1))),
                    "20 samples of a pixel are there already, and 19 are wanted");
}

TEST_CASE("a render with more samples in a single pixel than are wanted does not go on") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult done = render_with(scene, path, kept_options(20, 1));
  RenderState amid_pass = done;
  amid_pass.samples = 16;
  CHECK_THROWS_WITH(render_with(scene, path, resuming(amid_pass, kept_options(19, 1))),
                    "20 samples of a pixel are there already, and 19 are wanted");
  RenderOptions adaptive = kept_options(40, 1);
  adaptive.adaptive = AdaptiveSampling{8, 1e6};
  const RenderResult calm = render_with(scene, path, adaptive);
  RenderOptions fewer = resuming(calm, adaptive);
  fewer.samples = 39;
  CHECK_THROWS_WITH(render_with(scene, path, fewer),
                    "40 samples of a pixel are there already, and 39 are wanted");
}

TEST_CASE("passes end at the same places wherever a render goes on") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const RenderResult done = render_with(scene, path, kept_options(20, 1));
  RenderOptions more = resuming(done, kept_options(50, 2));
  std::vector<std::uint32_t> ends;
  more.pass_done = [&](const Film& film) { ends.push_back(film.pixel(7, 7).count); };
  render_with(scene, path, more);
  CHECK(ends == std::vector<std::uint32_t>{32, 48, 50});
}

TEST_CASE("a noise target ends a render that goes on where it would have ended") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  RenderOptions target = kept_options(4096, 2);
  target.half_layers.emplace();
  target.noise_target = 0.02;
  const RenderResult expected = render_with(scene, path, target);
  REQUIRE(expected.samples < 1000);
  REQUIRE(expected.samples > 16);
  const std::vector<RenderState> states = states_of(scene, path, target, 5);
  REQUIRE(states.size() > 3);
  for (const RenderState& state : states)
    CHECK(is_same(render_with(scene, path, resuming(state, target)), expected));
  CHECK(is_same(render_with(scene, path, resuming(expected, target)), expected));
}

TEST_CASE("ranges of samples make one picture together") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 3});
  const RenderOptions plain = rich(kept_options(23, 2));
  const RenderResult expected = render_with(scene, path, plain);
  RenderState sum = empty_state(plain, scene);
  for (const SampleRange range : {SampleRange{7, 21}, {0, 1}, {21, 23}, {1, 7}}) {
    RenderOptions part = plain;
    part.range = range;
    const RenderResult result = render_with(scene, path, part);
    CHECK(result.is_complete);
    CHECK(result.samples == range.end);
    CHECK(result.film.pixel(3, 3).count == range.end - range.begin);
    sum.film.merge(result.film);
    sum.halves->first.merge(result.halves->first);
    sum.halves->second.merge(result.halves->second);
    sum.rays += result.rays;
    // A part goes on as the whole does.
    for (const RenderState& state : states_of(scene, path, part, 9))
      CHECK(is_same(render_with(scene, path, resuming(state, part)), result));
  }
  sum.samples = 23;
  CHECK(is_same(sum, expected));
}

TEST_CASE("ranges of tiles make one picture together, adaptive or not") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  for (const bool is_adaptive : {false, true}) {
    RenderOptions plain = kept_options(40, 2);
    plain.window = PixelRect{3, 2, 38, 29};  // 3 x 2 tiles
    if (is_adaptive) plain.adaptive = AdaptiveSampling{8, 0.3};
    const RenderResult expected = render_with(scene, path, plain);
    RenderState sum = empty_state(plain, scene);
    for (const TileRange range : {TileRange{4, 6}, {0, 2}, {2, 4}}) {
      RenderOptions part = plain;
      part.tiles = range;
      const RenderResult result = render_with(scene, path, part);
      CHECK(result.is_complete);
      CHECK(result.film.window() == rows_of(range, *plain.window, tile_size));
      sum.film.merge(result.film);
      sum.rays += result.rays;
    }
    sum.samples = 40;
    CHECK(is_same(sum, expected));
  }
}

TEST_CASE("parts that could not be merged are refused") {
  const Scene scene = small_room();
  const PathIntegrator path(scene, {.max_depth = 2});
  const auto message = [&](const std::function<void(RenderOptions&)>& change) -> std::string {
    RenderOptions wrong = kept_options(16, 1);
    change(wrong);
    try {
      render_with(scene, path, wrong);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message([](RenderOptions& o) {
          o.range = {4, 17};
        }) == "samples 4 to 17: valid are a begin below the end, and an end of up to 16");
  CHECK(message([](RenderOptions& o) { o.range = {4, 4}; }).starts_with("samples 4 to 4: valid are"));
  CHECK(message([](RenderOptions& o) {
          o.tiles = {0, 7};
        }) == "tiles 0 to 7: valid are a begin below the end, and an end of up to 6");
  CHECK(message([](RenderOptions& o) {
          o.range = {0, 4};
          o.adaptive.emplace();
        }) == "adaptive sampling needs all samples of a pixel: its parts are ranges of tiles");
  CHECK(message([](RenderOptions& o) {
          o.range = {0, 4};
          o.tiles = {0, 1};
        }) == "a part of a render is a range of samples, or one of tiles, not both");
  CHECK(message([](RenderOptions& o) {
          o.tiles = {0, 1};
          o.half_layers.emplace();
          o.noise_target = 0.1;
        }) == "a noise target needs all samples of the picture, not a part");
}

}  // namespace twinray::test
