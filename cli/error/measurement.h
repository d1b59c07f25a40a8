// SPDX-License-Identifier: Apache-2.0
// What `twinray error` measures: pictures of several seeds, by several sets of options, with several numbers
// of samples, against a converged one.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/bias.h"
#include "cli/error/option_set.h"
#include "core/scene.h"
#include "integrators/render.h"

namespace twinray::error {

/// Whoever waits for a long work.
struct Watch {
  std::function<bool()> is_stopped;  ///< Once true, the work ends early.
  /// Gets what is being rendered, and how many pixel samples are done, of how many.
  std::function<void(const std::string& doing, std::uint64_t done, std::uint64_t total)> progress;
};

/// A picture that was rendered to be measured.
struct Sampled {
  Image mean;
  double cpu_seconds = 0;        ///< Of all threads, for the sampling alone.
  double samples_per_pixel = 0;  ///< On average: adaptive sampling may take fewer than it may.
  bool is_complete = true;       ///< False where it was stopped.
};

/// A scene with an engine, ready to be rendered by one set of options.
class Subject {
 public:
  /// Loads and builds; prints warnings. Throws Error.
  explicit Subject(const OptionSet& set);

  const OptionSet& set() const { return set_; }
  /// With this seed and number of samples in place of the set's own; `progress` gets the pixel samples done.
  Sampled render(std::uint64_t seed, std::uint32_t samples, const std::function<bool()>& is_stopped,
                 const std::function<void(std::uint64_t)>& progress) const;
  /// The pixels that see no emitter; those of a search that was stopped say nothing.
  PixelMask without_emitters(const std::function<bool()>& is_stopped) const;
  std::uint64_t pixel_count() const;

 private:
  OptionSet set_;
  std::unique_ptr<const LoadedScene> loaded_;
  std::unique_ptr<const Accelerator> accelerator_;
  std::unique_ptr<const Integrator> integrator_;
};

/// One set of options with one number of samples; of each seed one entry.
struct Point {
  std::uint32_t samples = 0;              ///< Asked for.
  std::vector<double> samples_per_pixel;  ///< Taken.
  std::vector<double> cpu_seconds;
  std::vector<SquaredError> errors;  ///< The converged picture's own error included.
  PictureMoments moments;
};

struct Curve {
  std::string name;
  Words options;
  std::vector<Point> points;  ///< By rising numbers of samples.
};

struct Measurement {
  ConvergedPicture converged;
  PixelMask mask;
  std::vector<Curve> curves;  ///< One a set.
};

/// What is rendered against the converged picture.
struct Rounds {
  std::vector<std::uint32_t> samples;  ///< Rising.
  int seeds = 4;                       ///< Of each point.
  std::uint64_t first_seed = 0;        ///< The others follow it.
};

/// Fills the measurement's curves; its converged picture and mask are there. With every seed all subjects
/// take turns, so that whatever slows the machine down for a while hits all of them alike. False where it was
/// stopped: the pictures that are complete are in the curves.
bool measure(const std::vector<Subject>& subjects, const Rounds& rounds, const Watch& watch,
             Measurement& measurement);

/// Two pictures of half the samples each, an even number, with this seed and the next. None where it was
/// stopped.
std::optional<ConvergedPicture> render_converged(const Subject& subject, std::uint32_t samples,
                                                 std::uint64_t seed, const Watch& watch);

}  // namespace twinray::error
