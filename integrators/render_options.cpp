// SPDX-License-Identifier: Apache-2.0
#include "integrators/render_options.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/error.h"

namespace twinray {
namespace {

void check_target(const RenderOptions& options) {
  if (!(*options.noise_target > 0) || !std::isfinite(*options.noise_target))
    throw Error(
        fmt::format("a noise target of {}; it must be finite and more than 0", *options.noise_target));
  if (!options.half_layers) throw Error("a noise target needs the halves of the samples");
}

/// What several renders share must not depend on samples that one of them does not have.
void check_part(const RenderOptions& options) {
  if (options.range && options.tiles)
    throw Error("a part of a render is a range of samples, or one of tiles, not both");
  if (options.noise_target) throw Error("a noise target needs all samples of the picture, not a part");
  if (options.allocation == Allocation::error)
    throw Error("samples are spread by the error of the whole picture, which a part does not have");
  if (options.range && options.adaptive)
    throw Error("adaptive sampling needs all samples of a pixel: its parts are ranges of tiles");
  if (const auto range = options.range;
      range && !(range->begin < range->end && range->end <= options.samples))
    throw Error(fmt::format("samples {} to {}: valid are a begin below the end, and an end of up to {}",
                            range->begin, range->end, options.samples));
  const std::uint32_t tiles = tile_grid(window_of(options), tile_size).count();
  if (const auto range = options.tiles; range && !(range->begin < range->end && range->end <= tiles))
    throw Error(fmt::format("tiles {} to {}: valid are a begin below the end, and an end of up to {}",
                            range->begin, range->end, tiles));
}

}  // namespace

void check(const RenderOptions& options) {
  if (options.samples < 1 || options.samples > Film::max_samples)
    throw Error(fmt::format("{} samples per pixel; valid are 1 to {}", options.samples, Film::max_samples));
  if (options.seconds && !(*options.seconds > 0 && std::isfinite(*options.seconds)))
    throw Error(fmt::format("{} seconds; they must be finite and more than 0", *options.seconds));
  if (std::set(options.layers.begin(), options.layers.end()).size() != options.layers.size())
    throw Error("a layer of a render is asked for twice");
  if (options.noise_target) check_target(options);
  if (options.range || options.tiles) check_part(options);
  if (options.motion && options.motion->samples_per_moment < 1)
    throw Error("no samples of a moment; there must be 1 at least");
  if (options.motion && options.adaptive)
    throw Error("adaptive sampling stops where nothing has been seen yet: not where something moves");
  if (options.motion && options.allocation == Allocation::error)
    throw Error(
        "samples are spread by what a pixel has seen, and all pixels see the same moments: not where "
        "something moves");
  if (options.half_light_groups && !(options.half_layers && options.light_groups))
    throw Error("halves by light groups need halves, and a film by light groups");
  if (!options.adaptive) return;
  if (options.allocation == Allocation::error)
    throw Error("samples are spread by error, or adaptive sampling takes fewer; not both");
  if (options.adaptive->batch < 1)
    throw Error(
        fmt::format("a batch of {} samples; adaptive sampling needs at least 1", options.adaptive->batch));
  if (!(options.adaptive->tolerance >= 0) || !std::isfinite(options.adaptive->tolerance))
    throw Error(
        fmt::format("a tolerance of {}; it must be finite and not negative", options.adaptive->tolerance));
}

FilmContents film_contents(const RenderOptions& options, const Scene& scene) {
  return {options.layers,
          {options.light_paths ? light_path_count : 0, options.light_groups ? scene.light_groups.size() : 0}};
}

FilmContents half_contents(const RenderOptions& options, const Scene& scene) {
  return {options.half_layers.value_or(std::vector<Layer>{}),
          {0, options.half_light_groups ? scene.light_groups.size() : 0}};
}

PixelRect window_of(const RenderOptions& options) {
  return options.window.value_or(PixelRect{0, 0, options.width, options.height});
}

PixelRect film_window(const RenderOptions& options) {
  const PixelRect window = window_of(options);
  return options.tiles ? rows_of(*options.tiles, window, tile_size) : window;
}

SampleRange samples_of(const RenderOptions& options) {
  return options.range.value_or(SampleRange{0, options.samples});
}

}  // namespace twinray
