// SPDX-License-Identifier: Apache-2.0
#include "integrators/motion.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "core/error.h"
#include "integrators/path.h"
#include "integrators/render.h"
#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/estimate.h"
#include "tests/support/film_bytes.h"
#include "tests/support/scenes.h"

namespace twinray::test {
namespace {

/// A room whose camera moves to the side while the shutter is open.
class SlidingRoom {
 public:
  TracedScene at(double part) {
    parts.push_back(part);
    scene_ = std::make_unique<Scene>(small_room());
    scene_->camera.position.x += float(part);
    accelerator_ = build_accelerator(Backend::bvh, scene_->geometry, {});
    integrator_ = std::make_unique<PathIntegrator>(*scene_, PathOptions{.max_depth = 2});
    return {*scene_, *accelerator_, *integrator_};
  }
  Motion motion(std::uint32_t samples_per_moment) {
    return {samples_per_moment, [this](double part) { return at(part); }};
  }

  std::vector<double> parts;  ///< That were asked for.

 private:
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Accelerator> accelerator_;
  std::unique_ptr<Integrator> integrator_;
};

RenderOptions motion_options(std::uint32_t samples) {
  return {
      .width = 24, .height = 18, .samples = samples, .layers = {Layer::position}, .seed = 3, .threads = 2};
}

RenderResult render_moving(SlidingRoom& room, RenderOptions options, std::uint32_t samples_per_moment) {
  const Scene still = small_room();
  const PathIntegrator path(still, {.max_depth = 2});
  options.motion = room.motion(samples_per_moment);
  return render_with(still, path, options);
}

}  // namespace

TEST_CASE("of any aligned block of moments one lies in each part of the shutter's time") {
  for (const std::uint64_t seed : {0u, 1u, 77u})
    for (const std::uint32_t count : {2u, 8u, 64u})
      for (const std::uint32_t begin : {0u, count, 5 * count}) {
        // The offset is the same for all: around the end, they are 1 / count apart.
        std::vector<double> times;
        for (std::uint32_t i = begin; i < begin + count; ++i) times.push_back(shutter_part(i, seed));
        std::sort(times.begin(), times.end());
        CHECK(times.front() >= 0);
        CHECK(times.back() < 1);
        for (std::size_t i = 1; i < times.size(); ++i)
          CHECK(times[i] - times[i - 1] == Approx(1.0 / count).epsilon(1e-6));
      }
}

TEST_CASE("over many seeds a moment is at any time of the shutter as likely") {
  constexpr int seeds = 4000;
  double sum = 0, squares = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const double time = shutter_part(0, std::uint64_t(seed));
    sum += time;
    squares += time * time;
  }
  // Four standard deviations of a mean of uniform numbers, and of their squares.
  CHECK(std::fabs(sum / seeds - 0.5) < 4 * 0.289 / std::sqrt(seeds));
  CHECK(std::fabs(squares / seeds - 1.0 / 3) < 4 * 0.298 / std::sqrt(seeds));
}

TEST_CASE("each moment's samples are those that its still scene has") {
  SlidingRoom room;
  const RenderResult moving = render_moving(room, motion_options(8), 3);
  REQUIRE(room.parts == std::vector{shutter_part(0, 3), shutter_part(1, 3), shutter_part(2, 3)});
  std::optional<Film> sum;
  for (const SampleRange range : {SampleRange{0, 3}, SampleRange{3, 6}, SampleRange{6, 8}}) {
    SlidingRoom alone;
    const TracedScene still = alone.at(shutter_part(range.begin / 3, 3));
    RenderOptions options = motion_options(8);
    options.range = range;
    const RenderResult part = render(still.scene, still.accelerator, still.integrator, options);
    sum ? sum->merge(part.film) : (void)sum.emplace(part.film);
  }
  CHECK(bytes_of(moving.film) == bytes_of(*sum));
}

TEST_CASE("a picture of motion that goes on has the bits of one that was made at once") {
  SlidingRoom room, again;
  const RenderResult expected = render_moving(room, motion_options(11), 2);
  const RenderResult begun = render_moving(again, motion_options(5), 2);
  RenderOptions rest = motion_options(11);
  rest.restore = [&](RenderState& state) { state = begun; };
  const RenderResult result = render_moving(again, rest, 2);
  CHECK(bytes_of(result.film) == bytes_of(expected.film));
}

TEST_CASE("where a moment cannot be had, the samples before it are handed over") {
  SlidingRoom room;
  const Scene still = small_room();
  const PathIntegrator path(still, {.max_depth = 2});
  RenderOptions options = motion_options(9);
  int moments = 0;
  options.motion = Motion{3, [&](double part) {
                            if (++moments > 2) throw Error("no third moment");
                            return room.at(part);
                          }};
  std::optional<RenderState> kept;
  options.failed = [&](const RenderState& state) { kept.emplace(state); };
  CHECK(error_text([&] { render_with(still, path, options); }) == "no third moment");
  REQUIRE(kept);
  CHECK(kept->samples == 6);
  CHECK(kept->film.pixel(3, 4).count == 6);
  CHECK(kept->seconds > 0);
}

TEST_CASE("no noise target is reached by the samples of few moments") {
  SlidingRoom room;
  RenderOptions options = motion_options(64);
  options.half_layers.emplace();
  options.noise_target = 1000;
  CHECK(render_moving(room, options, 4).samples == 64);
  CHECK(room.parts.size() == 16);
  options.samples = 100;
  CHECK(render_moving(room, options, 4).samples == 64);
  CHECK(render_moving(room, options, 1).samples == 16);
}

TEST_CASE("motion goes with as many samples of each pixel, and a moment has a sample at least") {
  SlidingRoom room;
  RenderOptions spread = motion_options(24);
  spread.allocation = Allocation::error;
  CHECK(error_text([&] { render_moving(room, spread, 4); }).find("samples are spread by what") == 0);
  RenderOptions adaptive = motion_options(8);
  adaptive.adaptive.emplace();
  CHECK(error_text([&] { render_moving(room, adaptive, 4); }).find("adaptive sampling stops") == 0);
  CHECK(error_text([&] { render_moving(room, motion_options(8), 0); }) ==
        "no samples of a moment; there must be 1 at least");
  CHECK(room.parts.empty());
}

}  // namespace twinray::test
