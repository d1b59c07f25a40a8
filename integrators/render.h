// SPDX-License-Identifier: Apache-2.0
// Passes x tiles x samples -> film.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "accel/accelerator.h"
#include "core/film.h"
#include "core/scene.h"
#include "integrators/half_films.h"
#include "integrators/integrator.h"
#include "integrators/render_options.h"

namespace twinray {

/// How far a render is, between two samples. In each pixel lie the first samples of those that it is to have,
/// without a gap: nothing else decides what is still to be done. (Where samples are spread by error, those of
/// the pilot decide; a render that goes on makes them again.)
struct RenderState {
  Film film;
  std::optional<HalfFilms> halves = {};  ///< Where they are asked for.
  RayCounts rays = {};
  std::uint32_t samples = 0;  ///< The passes before this index are done, and judged by the noise target.
  std::uint32_t next_estimate = 0;   ///< Of an error, where that takes long: not with fewer samples.
  std::optional<double> error = {};  ///< As estimated after the last pass, where there is a target.
  double seconds = 0;                ///< Wall-clock time of the sampling alone, of all processes.
};

/// The state that a render begins with: empty.
RenderState empty_state(const RenderOptions& options, const Scene& scene);

struct RenderProgress {
  std::uint64_t samples_done = 0;  ///< Pixel samples, those that adaptive sampling saved included.
  std::uint64_t samples_total = 0;
  double seconds_total = std::numeric_limits<double>::infinity();  ///< That this process may sample.
  double seconds_before = 0;                                       ///< That earlier ones did.
  std::optional<double> noise_target;                              ///< At which it ends.
  std::optional<double> error;  ///< Where there is a target: after the last pass that was looked at.
  std::uint64_t rays = 0;
};

/// A render that has ended.
struct RenderResult : RenderState {
  bool is_complete = true;  ///< False where it was stopped; pixels then have different numbers of samples.
};

/// Renders the scene as its camera sees it; where something moves, the scenes of its moments, and `scene`
/// says what their film holds. The film depends on scene, integrator and options alone: not on threads, nor
/// on the accelerator (but for embree_native). One sample goes through the pixel's centre, several through
/// random points of it. `progress`, if set, is called from one thread at a time, after each tile and each
/// look at the error. Throws Error for options out of range.
RenderResult render(const Scene& scene, const Accelerator& accelerator, const Integrator& integrator,
                    const RenderOptions& options,
                    const std::function<void(const RenderProgress&)>& progress = {});

}  // namespace twinray
