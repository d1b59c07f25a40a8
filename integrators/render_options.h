// SPDX-License-Identifier: Apache-2.0
// What is to be rendered, and who watches.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/film.h"
#include "core/pixel_filter.h"
#include "core/record.h"
#include "core/sampler.h"
#include "core/scene.h"
#include "integrators/adaptive.h"
#include "integrators/allocation.h"
#include "integrators/half_films.h"
#include "integrators/integrator.h"
#include "integrators/motion.h"
#include "integrators/tiles.h"

namespace twinray {

struct RenderState;

/// With fewer samples a pixel no render ends by a noise target, nor with fewer moments where something moves:
/// chance may make any picture look clean.
inline constexpr std::uint32_t least_samples_of_target = 16;

/// Samples [begin, end) of each pixel.
struct SampleRange {
  std::uint32_t begin = 0, end = 0;
  bool operator==(const SampleRange&) const = default;
};

/// The side of the tiles that a picture is cut into.
inline constexpr int tile_size = 16;

struct RenderOptions {
  int width = 480, height = 360;    ///< Of the full frame, in pixels.
  std::optional<PixelRect> window;  ///< What to render, also beside it; all if not set.
  std::uint32_t samples = 32;       ///< Per pixel; the most per pixel where sampling is adaptive.
  std::optional<AdaptiveSampling> adaptive;
  /// How they are spread: by error, `samples` is their mean. Not where sampling is adaptive.
  Allocation allocation = Allocation::even;
  /// A part of a render that several share: these of its samples alone; not with a noise target, nor where
  /// sampling is adaptive, nor spread by error,
  std::optional<SampleRange> range;
  /// or these tiles of tile_size alone; not with a noise target, nor where samples are spread by error.
  std::optional<TileRange> tiles;
  /// If set, sampling ends with the last pass over all pixels that is likely to be over by then, wall-clock
  /// time, or with the first one; the picture is that of as many samples.
  std::optional<double> seconds;
  /// Of a scene in which something moves. Not where sampling is adaptive, since what has not come yet would
  /// look converged; nor where samples are spread by error, since neighbours see the same moments.
  std::optional<Motion> motion;
  std::vector<Layer> layers;  ///< Of the film besides its colours, in this order, each once.
  bool light_paths = false;   ///< Divide the light by the paths that it took,
  bool light_groups = false;  ///< by the scene's light groups.
  /// Samples lie where it sees, pixels of one sample have theirs in the middle.
  PixelFilter filter;
  /// If set, the samples are kept in two halves as well, each with these layers,
  std::optional<std::vector<Layer>> half_layers;
  bool half_light_groups = false;  ///< and with the light by light groups, where the film has it.
  /// If set, with half_layers, sampling ends with the first pass, from least_samples_of_target on, after
  /// which the picture's error is not above: the root of its relative mean squared error, estimated by the
  /// halves (integrators/denoise/half_pictures.h). A function of the samples alone.
  std::optional<double> noise_target;
  /// If set, it estimates that error of what is made of the halves, in place of the error of the picture
  /// itself. It may take long: it is asked after passes that have a quarter more samples than at the last
  /// time.
  std::function<double(const HalfFilms&)> estimated_error;
  SamplerKind sampler = SamplerKind::sobol;
  std::uint64_t seed = 0;
  int threads = 0;        ///< 0: as many as the process may use.
  bool counting = false;  ///< Count what each ray does in the accelerator; slower.
  /// Of the lanes that make camera rays: one of available_instruction_sets(). It changes no bit.
  std::string simd = "best";
  /// If set, gets the rays of each sample once it is done: from any thread, those of one pixel one after the
  /// other.
  std::function<void(const PixelSample&, std::span<const RecordedRay>)> observe;
  /// If set, gets the film, and a tile of which all samples of the pass are there: from the thread that made
  /// them, which alone changes the tile until the pass ends, while others change others.
  std::function<void(const Film&, const PixelRect&)> tile_done;
  /// If set, gets the film after each pass, in which pixels then have all its samples; the next pass waits.
  std::function<void(const Film&)> pass_done;
  /// If set, asked many times a second, from any thread: once it says true, rendering ends with the samples
  /// that are there.
  std::function<bool()> is_stopped;
  /// If set, asked between tiles, from any thread: once it says true all threads rest, and `paused` gets the
  /// render as it is; then it goes on.
  std::function<bool()> is_pause_due;
  std::function<void(const RenderState&)> paused;
  /// If set, gets the render as it is where a moment of Motion cannot be had, before the Error is thrown on.
  std::function<void(const RenderState&)> failed;
  /// If set, may fill the state that a render begins with, which is empty, with that of an earlier one of the
  /// same scene and options, but for the number of samples (docs/films.md). Throws Error.
  std::function<void(RenderState&)> restore;
};

/// What the film of a scene's render keeps.
FilmContents film_contents(const RenderOptions& options, const Scene& scene);
/// What each of its halves keeps, where there are any.
FilmContents half_contents(const RenderOptions& options, const Scene& scene);

/// The picture's pixels: the window or, without one, the full frame.
PixelRect window_of(const RenderOptions& options);
/// Those of its film: of some of its tiles, the rows in which they lie.
PixelRect film_window(const RenderOptions& options);
/// The samples of a pixel that are rendered.
SampleRange samples_of(const RenderOptions& options);

/// Throws Error where options are out of range, or do not go together.
void check(const RenderOptions& options);

}  // namespace twinray
